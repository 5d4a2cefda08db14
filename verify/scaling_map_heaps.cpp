// SPDX-License-Identifier: MIT
#include "verify/scaling_map_heaps.hpp"

#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <sys/file.h>
#include <unistd.h>
#include <vector>

namespace verify {
namespace {

constexpr std::size_t columns_before = 6, columns_after = 3;  // of the values

std::string header() {
    std::string text = "heap,seed,setup,git,at_rest,missed";
    for (const MapMargin& m : map_margins()) text += fmt::format(",{} [{}]", m.name, m.unit);
    return text + ",grains_on_base [1],grain_steps [1],seconds [s]";
}

// As few digits as give the same double again.
std::string line_of(const MapHeap& h) {
    std::string text = fmt::format("{},{},{},{},{},{}", h.name, h.seed, h.setup, h.git,
                                   h.at_rest ? 1 : 0, fmt::join(h.missed, " "));
    for (const auto& value : h.values)
        text += value && std::isfinite(*value) ? fmt::format(",{}", *value) : ",";
    return text + fmt::format(",{},{},{}", h.grains_on_base, h.grain_steps, h.seconds);
}

template <class Number>
bool read_number(const std::string& text, Number& number) {
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    return fault == std::errc{} && end == text.data() + text.size();
}

bool read_line(const std::string& line, MapHeap& h) {
    std::vector<std::string> cells(1);
    for (const char c : line)
        if (c == ',')
            cells.emplace_back();
        else
            cells.back() += c;
    const std::size_t values = map_margins().size();
    if (cells.size() != columns_before + values + columns_after) return false;
    h.name = cells[0], h.setup = cells[2], h.git = cells[3];
    h.at_rest = cells[4] == "1";
    std::istringstream missed(cells[5]);
    for (std::string criterion; missed >> criterion;) h.missed.push_back(criterion);
    h.formed = h.at_rest && h.missed.empty();
    for (std::size_t k = 0; k < values; ++k) {
        const std::string& cell = cells[columns_before + k];
        double value = 0.0;
        if (!cell.empty() && !read_number(cell, value)) return false;
        h.values.push_back(cell.empty() ? std::nullopt : std::optional(value));
    }
    const std::size_t last = columns_before + values;
    return (cells[4] == "0" || cells[4] == "1") && read_number(cells[1], h.seed) &&
           read_number(cells[last], h.grains_on_base) &&
           read_number(cells[last + 1], h.grain_steps) && read_number(cells[last + 2], h.seconds);
}

std::string text_in(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    if (in) text << in.rdbuf();
    return text.str();
}

// Other processes wait while this one has the file.
struct Locked {
    int file;
    explicit Locked(const std::filesystem::path& path)
        : file(open(path.c_str(), O_RDWR | O_CREAT | O_APPEND, 0644)) {
        if (file < 0 || flock(file, LOCK_EX) != 0)
            throw std::runtime_error(path.string() + ": cannot be written");
    }
    ~Locked() { close(file); }
    Locked(const Locked&) = delete;
    Locked& operator=(const Locked&) = delete;
};

}  // namespace

MapHeaps read_heaps(const std::filesystem::path& file) {
    std::string text = text_in(file);
    text.resize(text.find_last_of('\n') + 1);  // npos + 1 = 0
    std::istringstream lines(text);
    MapHeaps heaps;
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        MapHeap h{};
        if (number > 1 && line == header()) continue;
        if (number == 1 ? line != header() : !read_line(line, h))
            throw scaling::InvalidInput(scaling::mistake(
                fmt::format("{}: line {}", file.string(), number), line.substr(0, 60),
                number == 1 ? "must be the header of a map's heaps" : "must be a heap",
                "take a file that similitude verify scaling-map has written"));
        if (number > 1) heaps[{h.name, h.setup}] = std::move(h);
    }
    return heaps;
}

void append_heap(const std::filesystem::path& file, const MapHeap& h) {
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    const Locked locked(file);
    const std::string before = text_in(file);
    const std::size_t whole = before.find_last_of('\n') + 1;
    const std::string more = (whole == 0 ? header() + "\n" : "") + line_of(h) + "\n";
    if (ftruncate(locked.file, static_cast<off_t>(whole)) != 0 ||
        write(locked.file, more.data(), more.size()) != static_cast<ssize_t>(more.size()))
        throw std::runtime_error(file.string() + ": cannot be written (disk full?)");
}

}  // namespace verify
