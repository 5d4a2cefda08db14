// SPDX-License-Identifier: MIT
#include "cases/messages.hpp"

#include "scaling/nearest_name.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace cases {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

// Edit distance in half edits: a letter put in, left out or changed is 2, in the wrong case 1, two neighbours exchanged 2.
int half_edits(const std::string& a, const std::string& b) {
    const std::size_t width = b.size() + 1;
    std::vector<int> cost((a.size() + 1) * width);  // [letters of a][letters of b]
    for (std::size_t j = 0; j < width; ++j) cost[j] = 2 * static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        int* row = &cost[i * width];
        const int* above = row - width;
        row[0] = 2 * static_cast<int>(i);
        for (std::size_t j = 1; j < width; ++j) {
            const char x = a[i - 1], y = b[j - 1];
            const int change = x == y ? 0 : (lower(x) == lower(y) ? 1 : 2);
            row[j] = std::min({above[j] + 2, row[j - 1] + 2, above[j - 1] + change});
            const bool exchanged = i > 1 && j > 1 && x == b[j - 2] && a[i - 2] == y;
            if (exchanged) row[j] = std::min(row[j], cost[(i - 2) * width + j - 2] + 2);
        }
    }
    return cost.back();
}

}  // namespace

std::string in_quotes(const std::string& text) {
    constexpr std::size_t longest = 80;
    std::string shown = text.substr(0, longest);
    std::replace_if(
        shown.begin(), shown.end(),
        [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }, '?');
    return '"' + shown + (text.size() > longest ? "...\"" : "\"");
}

std::string nearest(const std::string& written, const std::vector<std::string>& known) {
    // Up to a third of the name wrong, but always one edit: more is another word.
    int best = std::max(2, 2 * static_cast<int>(written.size()) / 3) + 1;
    std::string found;
    for (const std::string& name : known) {
        const int edits = half_edits(written, name);
        if (edits < best) {
            best = edits;
            found = name;
        }
    }
    return found;
}

std::string suggestion(const std::string& written, const std::vector<std::string>& known) {
    const std::string near = nearest(written, known);
    return near.empty() ? "known: " + scaling::joined(known) : "did you mean \"" + near + "\"?";
}

}  // namespace cases
