// SPDX-License-Identifier: MIT
#include "cases/stl.hpp"

#include "cases/messages.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>

namespace cases {
namespace {

using Point = std::array<double, 3>;

constexpr std::size_t head = 84;          // bytes: a title of 80, the number of triangles
constexpr std::size_t per_triangle = 50;  // bytes: normal, three corners, 2 unused
constexpr double float_digit = 1.1920928955078125e-7;  // 2^-23
constexpr const char* again = "export the mesh again";

[[noreturn]] void refuse(const std::string& where, const std::string& got, const std::string& rule,
                         const std::string& remedy) {
    throw scaling::InvalidInput(scaling::mistake(where, got, rule, remedy));
}

std::string read_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file.is_open() || std::filesystem::is_directory(path))
        refuse(path, "no readable file", "must be an STL file",
               "check the name; it stands relative to case.json");
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::uint32_t little_endian(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 4; k-- > 0;)
        value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
    return value;
}

// Bytes of the binary file that these bytes would be the beginning of.
std::size_t stated_size(const std::string& bytes) {
    return bytes.size() < head ? head : head + per_triangle * little_endian(bytes, 80);
}

bool is_text(const std::string& bytes) {
    return std::all_of(bytes.begin(), bytes.end(), [](char c) {
        const auto u = static_cast<unsigned char>(c);
        return u >= 32 || std::isspace(u) != 0;  // UTF-8 in a title is text too
    });
}

// Corners, three by three.
std::vector<Point> binary_corners(const std::string& bytes) {
    const std::size_t count = little_endian(bytes, 80);
    std::vector<Point> corners;
    corners.reserve(3 * count);
    for (std::size_t t = 0; t < count; ++t)
        for (std::size_t corner = 1; corner <= 3; ++corner) {  // 0 is the normal
            Point p{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::uint32_t bits =
                    little_endian(bytes, head + per_triangle * t + 12 * corner + 4 * axis);
                float value = 0.0F;
                std::memcpy(&value, &bits, sizeof value);
                p[axis] = static_cast<double>(value);
            }
            corners.push_back(p);
        }
    return corners;
}

// Words of a text, one by one, and the line that the last one stood in.
class Words {
  public:
    Words(const std::string& path, const std::string& text) : path_(path), text_(text) {}

    std::string next() {
        skip_space();
        const std::size_t begin = at_;
        while (at_ < text_.size() && !space(text_[at_])) ++at_;
        return text_.substr(begin, at_ - begin);
    }
    void skip_line() {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    }
    // The word must be `wanted`, in small letters or capitals.
    void expect(const std::string& wanted) {
        const std::string got = next();
        if (lower(got) != wanted) refuse_word(got, "must be \"" + wanted + "\"");
    }
    double number() {
        const std::string got = next();
        const std::size_t from = got.starts_with('+') ? 1 : 0;
        double value = 0.0;
        const auto [end, error] =
            std::from_chars(got.data() + from, got.data() + got.size(), value);
        if (got.empty() || error != std::errc{} || end != got.data() + got.size())
            refuse_word(got, "must be a number");
        return value;
    }
    static std::string lower(std::string word) {
        std::transform(word.begin(), word.end(), word.begin(), [](char c) {
            return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        });
        return word;
    }
    [[noreturn]] void refuse_word(const std::string& got, const std::string& rule) const {
        refuse(fmt::format("{}: line {}", path_, line_),
               got.empty() ? "the end of the file" : in_quotes(got), rule,
               got.empty() ? "the file is cut off; export the mesh again" : again);
    }

  private:
    static bool space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
    void skip_space() {
        for (; at_ < text_.size() && space(text_[at_]); ++at_)
            if (text_[at_] == '\n') ++line_;
    }

    const std::string& path_;
    const std::string& text_;
    std::size_t at_ = 0;
    int line_ = 1;
};

// solid NAME { facet normal x y z outer loop (vertex x y z) x 3 endloop endfacet } endsolid NAME, and perhaps another solid.
std::vector<Point> text_corners(const std::string& path, const std::string& text) {
    Words words(path, text);
    std::vector<Point> corners;
    words.expect("solid");
    words.skip_line();
    for (;;) {
        const std::string word = Words::lower(words.next());
        if (word == "endsolid") {
            words.skip_line();
            const std::string more = words.next();
            if (more.empty()) return corners;
            if (Words::lower(more) != "solid") words.refuse_word(more, "must be \"solid\"");
            words.skip_line();
            continue;
        }
        if (word != "facet") words.refuse_word(word, "must be \"facet\" or \"endsolid\"");
        words.expect("normal");
        for (int k = 0; k < 3; ++k) words.next();  // not used, and some write nan there
        words.expect("outer"), words.expect("loop");
        for (int k = 0; k < 3; ++k) {
            words.expect("vertex");
            const double x = words.number(), y = words.number(), z = words.number();
            corners.push_back({x, y, z});
        }
        words.expect("endloop"), words.expect("endfacet");
    }
}

std::vector<Point> read_corners(const std::string& path) {
    const std::string bytes = read_bytes(path);
    const std::size_t stated = stated_size(bytes);
    if (bytes.size() >= head && bytes.size() == stated) return binary_corners(bytes);
    if (is_text(bytes)) return text_corners(path, bytes);
    if (bytes.size() < head)
        refuse(path, fmt::format("{} bytes", bytes.size()),
               "must be an STL file, 84 bytes at least", again);
    refuse(path, fmt::format("{} bytes", bytes.size()),
           fmt::format("must be {} bytes for the {} triangles it states", stated,
                       little_endian(bytes, 80)),
           bytes.size() < stated ? "the file is cut off; export the mesh again"
                                 : "there is more behind them; export the mesh again");
}

// Gives every corner the vertex that stands for it: the first within `tolerance`, in the order of the file.
class Welder {
  public:
    Welder(double tolerance, std::vector<Point>& vertices)
        : tolerance_(tolerance), vertices_(vertices) {}

    int vertex(const Point& p) {
        const auto known = same_.find(p);
        if (known != same_.end()) return known->second;
        int found = near(p);
        if (found < 0) {
            found = static_cast<int>(vertices_.size());
            vertices_.push_back(p);
            cells_.emplace(cell(p), found);
        }
        same_.emplace(p, found);
        return found;
    }

  private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cell(const Point& p) const {
        Cell c{};
        for (std::size_t k = 0; k < 3; ++k)
            c[k] = tolerance_ > 0.0
                       ? static_cast<std::int64_t>(std::floor(p[k] / (16.0 * tolerance_)))
                       : 0;
        return c;
    }
    int near(const Point& p) const {
        int found = -1;
        Point low = p, high = p;
        for (std::size_t k = 0; k < 3; ++k) low[k] -= tolerance_, high[k] += tolerance_;
        const Cell first = cell(low), last = cell(high);
        for (Cell c = first; c[0] <= last[0]; ++c[0])
            for (c[1] = first[1]; c[1] <= last[1]; ++c[1])
                for (c[2] = first[2]; c[2] <= last[2]; ++c[2]) {
                    const auto [begin, end] = cells_.equal_range(c);
                    for (auto at = begin; at != end; ++at) {
                        const Point& q = vertices_[static_cast<std::size_t>(at->second)];
                        const double d = std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
                        if (d <= tolerance_ && (found < 0 || at->second < found))
                            found = at->second;
                    }
                }
        return found;
    }

    double tolerance_;
    std::vector<Point>& vertices_;
    std::map<Point, int> same_;
    std::multimap<Cell, int> cells_;
};

// Whether it is at least a millionth of its longest edge high: below, floats cannot tell it from a line.
bool has_area(const std::vector<Point>& vertices, const std::array<int, 3>& triangle) {
    const auto at = [&](std::size_t k) { return vertices[static_cast<std::size_t>(triangle[k])]; };
    const Point a = at(0), b = at(1), c = at(2);
    Point u{}, v{};
    for (std::size_t k = 0; k < 3; ++k) u[k] = b[k] - a[k], v[k] = c[k] - a[k];
    const double twice_area =
        std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    const double longest = std::max({std::hypot(u[0], u[1], u[2]), std::hypot(v[0], v[1], v[2]),
                                     std::hypot(u[0] - v[0], u[1] - v[1], u[2] - v[2])});
    return twice_area >= 1e-6 * longest * longest;
}

void note_edges(Mesh& mesh) {
    std::map<std::pair<int, int>, int> uses;
    for (const auto& [i, j, k] : mesh.triangles)
        for (const auto& [a, b] : {std::pair{i, j}, std::pair{j, k}, std::pair{k, i}})
            ++uses[std::minmax(a, b)];
    const auto open =
        std::count_if(uses.begin(), uses.end(), [](const auto& edge) { return edge.second == 1; });
    const auto many =
        std::count_if(uses.begin(), uses.end(), [](const auto& edge) { return edge.second > 2; });
    if (open > 0)
        mesh.notes.push_back(fmt::format(
            "{}: {} open edges; fine for a funnel, not for a closed body", mesh.path, open));
    if (many > 0)
        mesh.notes.push_back(
            fmt::format("{}: {} edges with more than two triangles; the surface is parted there",
                        mesh.path, many));
}

}  // namespace

Mesh read_stl(const std::string& path, double unit) {
    const std::vector<Point> corners = read_corners(path);
    double largest = 0.0;
    for (std::size_t c = 0; c < corners.size(); ++c)
        for (const double x : corners[c]) {
            if (!std::isfinite(x))
                refuse(fmt::format("{}: triangle {}", path, c / 3 + 1), fmt::format("{}", x),
                       "must be a finite number", again);
            largest = std::max(largest, std::abs(x));
        }
    if (corners.empty()) refuse(path, "no triangle", "must hold a surface of triangles", again);

    Mesh mesh{.path = path, .vertices = {}, .triangles = {}, .notes = {}};
    Welder welder(4.0 * float_digit * largest, mesh.vertices);
    std::size_t lost = 0;
    bool any_area = false;
    for (std::size_t c = 0; c < corners.size(); c += 3) {
        const std::array<int, 3> t{welder.vertex(corners[c]), welder.vertex(corners[c + 1]),
                                   welder.vertex(corners[c + 2])};
        const bool whole = t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
        lost += whole ? 0 : 1;
        if (!whole) continue;
        mesh.triangles.push_back(t);
        any_area = any_area || has_area(mesh.vertices, t);
    }
    if (!any_area)
        refuse(path, fmt::format("{} triangles without area", corners.size() / 3),
               "must hold a surface of triangles", again);
    if (lost > 0)
        mesh.notes.push_back(fmt::format(
            "{}: {} triangles with two corners in one place were left out", path, lost));
    note_edges(mesh);
    for (Point& p : mesh.vertices)
        for (double& x : p) x *= unit;
    return mesh;
}

}  // namespace cases
