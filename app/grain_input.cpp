// SPDX-License-Identifier: MIT
#include "app/grain_input.hpp"

#include "cases/messages.hpp"
#include "cases/units.hpp"
#include "scaling/errors.hpp"
#include "scaling/nearest_name.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace app {

namespace {

using scaling::InvalidInput;
using scaling::mistake;

// "mm" or "2.5 mm" in SI.
double size_of_unit(const std::string& text, const char* si_unit, const char* where) {
    const bool bare =
        !text.empty() && std::string_view("0123456789+-.").find(text[0]) == std::string_view::npos;
    const double v =
        cases::to_si(bare ? "1 " + text : text, cases::parse_unit(si_unit, where), where);
    if (!(v > 0.0) || !std::isfinite(v))
        throw InvalidInput(mistake(where, cases::in_quotes(text), "must be > 0",
                                   "write a unit, such as mm, or a size, such as \"2.5 mm\""));
    return v;
}

std::optional<engines::FileUnits> units_of(const GrainInput& in) {
    const bool sizes = !in.length_unit.empty() || !in.time_unit.empty() || !in.mass_unit.empty();
    if (!in.units.empty() && sizes)
        throw InvalidInput(mistake("--units", cases::in_quotes(in.units),
                                   "must not stand beside --length-unit, --time-unit, --mass-unit",
                                   "state the one or the other"));
    if (!in.units.empty()) return engines::units_named(in.units, "--units");
    if (in.length_unit.empty() || in.time_unit.empty() || in.mass_unit.empty()) return {};
    return engines::FileUnits{"stated", size_of_unit(in.length_unit, "m", "--length-unit"),
                              size_of_unit(in.time_unit, "s", "--time-unit"),
                              size_of_unit(in.mass_unit, "kg", "--mass-unit")};
}

std::vector<int> types_of(const std::string& list) {
    std::vector<int> types;
    for (std::size_t from = 0; !list.empty() && from <= list.size();) {
        const std::size_t to = std::min(list.find(',', from), list.size());
        int type = 0;
        const auto [end, error] = std::from_chars(list.data() + from, list.data() + to, type);
        if (error != std::errc{} || end != list.data() + to)
            throw InvalidInput(mistake("--fixed-type", cases::in_quotes(list),
                                       "must be whole numbers", "such as 2, or 2,3"));
        types.push_back(type);
        from = to + 1;
    }
    return types;
}

}  // namespace

void add_grain_input(CLI::App& verb, GrainInput& in) {
    verb.add_option("--units", in.units,
                    "of files that do not say theirs: si, cgs, micro or nano, as LAMMPS has them");
    verb.add_option("--length-unit", in.length_unit,
                    "or each by itself: what a length of 1 is, such as mm or \"2.5 mm\"");
    verb.add_option("--time-unit", in.time_unit, "what a time of 1 is");
    verb.add_option("--mass-unit", in.mass_unit, "what a mass of 1 is");
    verb.add_option("--diameter", in.diameter, "of all grains, where the file has no sizes");
    verb.add_option("--density", in.density, "of all grains, where the file has no masses");
    verb.add_option("--fixed-type", in.fixed_type,
                    "types of grains that never move, such as a glued base")
        ->type_name("N[,N]");
    verb.add_option("--frame", in.frame, "last, or the number of a frame from 0 on")
        ->capture_default_str();
}

engines::GrainOptions grain_options(const GrainInput& in, const std::string& format_option) {
    engines::GrainOptions o;
    if (!in.format.empty()) {
        const auto& names = engines::grain_format_names();
        const auto at = std::find(names.begin(), names.end(), in.format);
        if (at == names.end())
            throw InvalidInput(mistake(format_option, cases::in_quotes(in.format),
                                       "must be one of " + scaling::joined(names),
                                       cases::suggestion(in.format, names)));
        o.format = static_cast<engines::GrainFormat>(at - names.begin());
    }
    o.units = units_of(in);
    if (!in.length_unit.empty()) o.length_unit = size_of_unit(in.length_unit, "m", "--length-unit");
    if (!in.diameter.empty()) o.diameter = size_of_unit(in.diameter, "m", "--diameter");
    if (!in.density.empty()) o.density = size_of_unit(in.density, "kg/m^3", "--density");
    o.fixed_types = types_of(in.fixed_type);
    return o;
}

std::optional<std::size_t> frame_wanted(const std::string& frame) {
    if (frame == "last") return {};
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(frame.data(), frame.data() + frame.size(), number);
    if (error != std::errc{} || end != frame.data() + frame.size())
        throw InvalidInput(mistake("--frame", cases::in_quotes(frame),
                                   "must be last or a whole number", "the first frame is 0"));
    return number;
}

ChosenFrame read_frame(const GrainInput& in, const std::string& format_option) {
    const std::optional<std::size_t> wanted = frame_wanted(in.frame);
    const auto reader = engines::open_grains(in.path, grain_options(in, format_option));
    ChosenFrame chosen;
    chosen.format = reader->format();
    std::size_t frames = 0;
    while ((!wanted || frames <= *wanted) && reader->next(chosen.grains)) ++frames;
    if (frames == 0)
        throw InvalidInput(
            mistake(in.path, "no frame", "must hold grains", "check the file and its format"));
    if (wanted && frames <= *wanted)
        throw InvalidInput(mistake("--frame", in.frame, fmt::format("must be below {}", frames),
                                   fmt::format("{} holds {} frames", in.path, frames)));
    chosen.number = frames - 1;
    return chosen;
}

}  // namespace app
