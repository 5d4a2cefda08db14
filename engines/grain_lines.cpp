// SPDX-License-Identifier: MIT
#include "engines/grain_lines.hpp"

#include "cases/messages.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

namespace engines {

void refuse(const std::string& where, const std::string& got, const std::string& rule,
            const std::string& remedy) {
    throw scaling::InvalidInput(scaling::mistake(where, got, rule, remedy));
}

Lines::Lines(const std::string& path) : path_(path), in_(path, std::ios::binary) {
    if (!in_.is_open() || std::filesystem::is_directory(path))
        refuse(path, "no readable file", "must be a file of grains", "check the name");
}

bool Lines::next() {
    if (again_) {
        again_ = false;
        return true;
    }
    if (!std::getline(in_, text_)) return false;
    ++number_;
    if (number_ == 1 && text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
    if (!text_.empty() && text_.back() == '\r') text_.pop_back();
    return true;
}

std::string Lines::at() const { return fmt::format("{}:{}", path_, number_); }

const std::string& Lines::need(const std::string& what) {
    if (!next())
        refuse(at(), "the end of the file", "must not end within " + what,
               "the writing was cut off: take an earlier frame with --frame, or write it again");
    return text_;
}

namespace {

bool blank(char c) { return c == ' ' || c == '\t'; }

std::string_view bare(std::string_view cell) {
    const auto trim = [&] {
        while (!cell.empty() && blank(cell.front())) cell.remove_prefix(1);
        while (!cell.empty() && blank(cell.back())) cell.remove_suffix(1);
    };
    trim();
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"') {
        cell = cell.substr(1, cell.size() - 2);
        trim();
    }
    return cell;
}

bool parse(std::string_view text, double& value) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    // A number too small for a double is 0 to every program that wrote or reads these files.
    if (error == std::errc::result_out_of_range && end == text.data() + text.size()) {
        value = std::strtod(std::string(text).c_str(), nullptr);
        return std::isfinite(value);
    }
    return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

}  // namespace

void split_words(std::string_view line, std::vector<std::string_view>& words) {
    words.clear();
    for (std::size_t k = 0; k < line.size();) {
        while (k < line.size() && blank(line[k])) ++k;
        const std::size_t from = k;
        while (k < line.size() && !blank(line[k])) ++k;
        if (k > from) words.push_back(line.substr(from, k - from));
    }
}

void split_cells(std::string_view line, std::vector<std::string_view>& cells) {
    cells.clear();
    for (std::size_t from = 0;; ++from) {
        const std::size_t to = std::min(line.find(',', from), line.size());
        cells.push_back(bare(line.substr(from, to - from)));
        if (to == line.size()) return;
        from = to;
    }
}

double Lines::number(std::string_view text, std::string_view what) const {
    double value = 0.0;
    if (!parse(text, value))
        refuse(fmt::format("{}: {}", at(), what), cases::in_quotes(std::string(text)),
               "must be a finite number", "with a decimal point and no unit behind it");
    return value;
}

bool is_number(std::string_view text) {
    double ignored = 0.0;
    return parse(text, ignored);
}

bool Table::has(Slot slot) const {
    return std::any_of(columns_.begin(), columns_.end(),
                       [&](const Column& c) { return c.slot == slot; });
}

Table::Table(std::vector<Column> columns, const GrainOptions& options, const std::string& where)
    : columns_(std::move(columns)), options_(options) {
    std::string names;
    for (const Column& c : columns_) names += (names.empty() ? "" : ", ") + c.name;
    for (std::size_t k = 0; k < columns_.size(); ++k)
        for (std::size_t i = 0; i < k; ++i)
            if (columns_[k].slot == columns_[i].slot && columns_[k].slot != Slot::unused)
                refuse(where, columns_[i].name + " and " + columns_[k].name,
                       "must not mean the same", "leave one of the two out");
    const auto place = [&](Slot plain, Slot scaled) { return has(plain) || has(scaled); };
    if (!place(Slot::x, Slot::scaled_x) || !place(Slot::y, Slot::scaled_y) ||
        !place(Slot::z, Slot::scaled_z))
        refuse(where, names, "must hold x, y and z of each grain", "write them as columns");
    const bool sized = has(Slot::radius) || has(Slot::diameter) || has(Slot::volume);
    if (!sized && !options.diameter)
        refuse(where, names, "must hold a radius or a diameter",
               "write one as a column, or state --diameter if all grains are alike");
    if (sized && options.diameter)
        refuse("--diameter", fmt::format("{} m", *options.diameter),
               "must not be stated where the file has sizes", "leave it out");
    if (options.density && (has(Slot::mass) || has(Slot::density)))
        refuse("--density", fmt::format("{} kg/m^3", *options.density),
               "must not be stated where the file has masses or densities", "leave it out");
}

void Table::begin(GrainFrame& f) const {
    f.frame = {};
    f.has_time = false;
    f.has_velocity = has(Slot::vx) && has(Slot::vy) && has(Slot::vz);
    f.has_spin = has(Slot::wx) && has(Slot::wy) && has(Slot::wz);
    f.has_mass = has(Slot::mass) || has(Slot::density) || options_.density;
    f.unused.clear();
    for (const Column& c : columns_)
        if (c.slot == Slot::unused) f.unused.push_back(c.name);
}

double Table::size_of(const std::array<double, slot_count>& row, const Where& where) const {
    const auto of = [&](Slot slot) { return row[static_cast<std::size_t>(slot)]; };
    double radius = std::numeric_limits<double>::quiet_NaN();
    if (options_.diameter) radius = 0.5 * *options_.diameter;
    if (has(Slot::volume)) radius = std::cbrt(0.75 * of(Slot::volume) / std::numbers::pi);
    if (has(Slot::diameter)) radius = 0.5 * of(Slot::diameter);
    if (has(Slot::radius)) radius = of(Slot::radius);
    if (!(radius > 0.0))
        refuse(where(), fmt::format("a grain of radius {} m", radius), "must be > 0",
               "points without a size cannot be measured: write their diameters");
    return radius;
}

void Table::add(GrainFrame& f, const std::vector<double>& values, const Where& where) const {
    std::array<double, slot_count> row{};
    for (std::size_t k = 0; k < columns_.size(); ++k)
        if (columns_[k].slot != Slot::unused)
            row[static_cast<std::size_t>(columns_[k].slot)] = values[k] * columns_[k].factor;
    const auto of = [&](Slot slot) { return row[static_cast<std::size_t>(slot)]; };
    rigs::Frame& g = f.frame;
    const auto whole = [&](Slot slot, std::int64_t otherwise) {
        if (!has(slot)) return otherwise;
        if (of(slot) != std::floor(of(slot)) || std::abs(of(slot)) > 9e15)
            refuse(where(), fmt::format("{}", of(slot)), "must be a whole number",
                   "ids and types are counted");
        return static_cast<std::int64_t>(of(slot));
    };
    const auto coordinate = [&](Slot plain, Slot scaled, double low, double high) {
        return has(plain) ? of(plain) : low + of(scaled) * (high - low);
    };
    const double radius = size_of(row, where);
    const double volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
    double mass = std::numeric_limits<double>::quiet_NaN();
    if (options_.density) mass = *options_.density * volume;
    if (has(Slot::density)) mass = of(Slot::density) * volume;
    if (has(Slot::mass)) mass = of(Slot::mass);
    if (f.has_mass && !(mass > 0.0))
        refuse(where(), fmt::format("a grain of {} kg", mass), "must be > 0",
               "correct its mass or density");
    g.id.push_back(whole(Slot::id, static_cast<std::int64_t>(g.count()) + 1));
    g.position.push_back({coordinate(Slot::x, Slot::scaled_x, g.low.x, g.high.x),
                          coordinate(Slot::y, Slot::scaled_y, g.low.y, g.high.y),
                          coordinate(Slot::z, Slot::scaled_z, g.low.z, g.high.z)});
    g.velocity.push_back(f.has_velocity ? contact::Vec3{of(Slot::vx), of(Slot::vy), of(Slot::vz)}
                                        : contact::Vec3{});
    g.spin.push_back(f.has_spin ? contact::Vec3{of(Slot::wx), of(Slot::wy), of(Slot::wz)}
                                : contact::Vec3{});
    g.radius.push_back(radius);
    g.mass.push_back(mass);
    const int type = static_cast<int>(whole(Slot::type, 1));
    g.type.push_back(type);
    const auto& fixed = options_.fixed_types;
    g.fixed.push_back(std::find(fixed.begin(), fixed.end(), type) != fixed.end() ? 1 : 0);
}

void enclose(rigs::Frame& f, bool box) {
    if (!box) f.low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, f.high = -f.low;
    for (std::size_t k = 0; k < f.count(); ++k) {
        const contact::Vec3 x = f.position[k];
        const double r = f.radius[k];
        f.low = {std::min(f.low.x, x.x - r), std::min(f.low.y, x.y - r),
                 std::min(f.low.z, x.z - r)};
        f.high = {std::max(f.high.x, x.x + r), std::max(f.high.y, x.y + r),
                  std::max(f.high.z, x.z + r)};
    }
    if (!box && f.count() == 0) f.low = f.high = {};
}

double factor_of(Slot slot, const FileUnits& u) {
    const double volume = u.length * u.length * u.length;
    switch (slot) {
        case Slot::x:
        case Slot::y:
        case Slot::z:
        case Slot::radius:
        case Slot::diameter:
            return u.length;
        case Slot::vx:
        case Slot::vy:
        case Slot::vz:
            return u.length / u.time;
        case Slot::wx:
        case Slot::wy:
        case Slot::wz:
            return 1.0 / u.time;
        case Slot::volume:
            return volume;
        case Slot::mass:
            return u.mass;
        case Slot::density:
            return u.mass / volume;
        default:
            return 1.0;
    }
}

}  // namespace engines
