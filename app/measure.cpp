// SPDX-License-Identifier: MIT
#include "app/measure.hpp"

#include "app/exit_code.hpp"
#include "app/grain_input.hpp"
#include "cases/csv.hpp"
#include "cases/messages.hpp"
#include "cases/units.hpp"
#include "reports/numbers.hpp"
#include "reports/text.hpp"
#include "rigs/measure.hpp"
#include "scaling/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <memory>

namespace app {

namespace {

using reports::Json;
using scaling::InvalidInput;
using scaling::mistake;

struct MeasureOptions {
    CommonOptions common;
    GrainInput input;
    std::string base_diameter, base_centre = "0 m,0 m", base_height = "0 m", up = "z";
    std::string contact_gap = "0 m", gravity = "9.81 m/s^2", profile;
};

double length_of(const std::string& text, const char* where, bool positive) {
    const double v = cases::quantity<scaling::Length>(text, where).value();
    if (!std::isfinite(v) || (positive && !(v > 0.0)))
        throw InvalidInput(mistake(where, cases::in_quotes(text),
                                   positive ? "must be > 0" : "must be finite", "with its unit"));
    return v;
}

rigs::MeasureSettings settings_of(const MeasureOptions& o) {
    rigs::MeasureSettings s;
    if (!o.base_diameter.empty())
        s.base_diameter = length_of(o.base_diameter, "--base-diameter", true);
    const std::size_t comma = o.base_centre.find(',');
    if (comma == std::string::npos)
        throw InvalidInput(mistake("--base-centre", cases::in_quotes(o.base_centre),
                                   "must be two lengths", "such as \"0 mm,12.5 mm\""));
    s.base = {length_of(o.base_centre.substr(0, comma), "--base-centre", false),
              length_of(o.base_centre.substr(comma + 1), "--base-centre", false),
              length_of(o.base_height, "--base-height", false)};
    s.contact_gap = length_of(o.contact_gap, "--contact-gap", false);
    if (s.contact_gap < 0.0)
        throw InvalidInput(mistake("--contact-gap", cases::in_quotes(o.contact_gap), "must be >= 0",
                                   "grains that overlap touch at 0"));
    s.gravity = cases::quantity<scaling::Acceleration>(o.gravity, "--gravity").value();
    if (!(s.gravity > 0.0))
        throw InvalidInput(mistake("--gravity", cases::in_quotes(o.gravity), "must be > 0",
                                   "its direction is against --up"));
    return s;
}

// Turns the axes so that `up` becomes z, right-handed: y up: (z, x, y); x up: (y, z, x).
void turn_up(rigs::Frame& f, const std::string& up) {
    const auto turned = [&](contact::Vec3 v) {
        if (up == "y") return contact::Vec3{v.z, v.x, v.y};
        if (up == "x") return contact::Vec3{v.y, v.z, v.x};
        return v;
    };
    for (contact::Vec3& v : f.position) v = turned(v);
    for (contact::Vec3& v : f.velocity) v = turned(v);
}

std::string text_of(const MeasureOptions& o, const ChosenFrame& chosen, const rigs::Measured& m) {
    const engines::GrainFrame& g = chosen.grains;
    std::string text = fmt::format(
        "{}: frame {}{}, {} grains: {} in the heap, {} fixed, {} below the base, {} beyond its "
        "rim\n",
        o.input.path, chosen.number,
        g.has_time ? ", " + cases::format_si(g.frame.time, "s") : std::string(), g.frame.count(),
        m.loose, m.fixed, m.below_base, m.beyond_rim);
    text += fmt::format(
        "  diameter {} (mean of {} to {}); {} contacts per grain by geometry, "
        "largest overlap {} of R*\n",
        cases::format_si(m.mean, "m"), cases::format_si(m.smallest, "m"),
        cases::format_si(m.largest, "m"), reports::number(m.contacts.coordination),
        reports::number(m.contacts.largest_overlap));
    if (!m.heap) return text + "  no angles: state --base-diameter, where the heap stands\n";
    if (!g.has_velocity)
        text += "  the file has no velocities: whether the heap is at rest is not known\n";
    text += m.heap->formed.formed
                ? "  a heap formed: every criterion is met\n"
                : "  no heap formed: " + reports::failed_criteria(m.heap->formed) + "\n";
    text += fmt::format("  packing fraction {}\n", m.heap->packing
                                                       ? reports::number(m.heap->packing->value)
                                                       : "not to be had (too small a heap)");
    return text + reports::columns(reports::angle_table(m.heap->angles), {false, true, true, true});
}

Json json_of(const MeasureOptions& o, const ChosenFrame& chosen, const rigs::MeasureSettings& s,
             const rigs::Measured& m, const std::string& command) {
    const engines::GrainFrame& g = chosen.grains;
    const auto format = static_cast<std::size_t>(chosen.format);
    Json json{{"format", "similitude-measure/1"},
              {"tool", reports::to_json(provenance(command, ""))},
              {"file", o.input.path},
              {"file_format", engines::grain_format_names()[format]},
              {"frame", chosen.number},
              {"step", g.frame.step},
              {"time", g.has_time ? Json(g.frame.time) : Json(nullptr)},
              {"units", "SI"},
              {"unused", g.unused}};
    json["base"] = {{"diameter", s.base_diameter ? Json(*s.base_diameter) : Json(nullptr)},
                    {"x", s.base.x},
                    {"y", s.base.y},
                    {"z", s.base.z},
                    {"up", o.up}};
    json["contact_gap"] = s.contact_gap;
    json["contacts_by"] = "geometry: surfaces at most contact_gap apart";
    json["velocities"] = g.has_velocity;
    json.update(reports::to_json(m));
    return json;
}

reports::Page page_of(const MeasureOptions& o, const ChosenFrame& chosen, const rigs::Measured& m,
                      const std::string& command) {
    const reports::RunSection heap =
        reports::heap_section(fmt::format("frame {}", chosen.number), m);
    reports::Page page{.title = std::filesystem::path(o.input.path).filename().string(),
                       .source = "grains that another program left in a file"};
    page.verdict = heap.verdict;
    page.runs = {heap};
    page.runs_heading = "The heap in the file";
    page.limits = {
        "One heap of one seed: its scatter from heap to heap is not known. The spread is that "
        "over sectors or views.",
        "Contacts are told by geometry: a neck that adhesion holds over a gap is not seen."};
    if (!chosen.grains.has_velocity)
        page.limits.push_back(
            "The file has no velocities: whether the heap is at rest is not known.");
    page.provenance = provenance(command, "");
    return page;
}

int run(const MeasureOptions& o, const std::string& command) {
    rigs::MeasureSettings settings = settings_of(o);
    ChosenFrame chosen = read_frame(o.input, "--format");
    turn_up(chosen.grains.frame, o.up);
    settings.moving_known = chosen.grains.has_velocity;
    const rigs::Measured m = rigs::measure(chosen.grains.frame, settings);
    print(o.common, text_of(o, chosen, m));
    write_results(o.common, json_of(o, chosen, settings, m, command),
                  [&] { return page_of(o, chosen, m, command); });
    if (!o.profile.empty() && m.heap)
        cases::write_csv(o.profile, {{"r", "m", m.heap->profile.r},
                                     {"z", "m", m.heap->profile.z},
                                     {"spread", "m", m.heap->profile.spread}});
    return m.heap && !m.heap->formed.formed ? answer_is_no : fine;
}

constexpr const char* examples = R"(Examples:
  similitude measure out/pile.lammpstrj --base-diameter "50 mm" --fixed-type 2
      angles, packing and contacts of the last frame of a dump
  similitude measure export.csv --format edem_csv --length-unit mm --diameter "2 mm"
      --base-diameter "100 mm" --up y --json -
      a heap that EDEM exported, in a model where y points up)";

}  // namespace

Verb measure_verb(CLI::App& app, const std::string& command) {
    const auto o = std::make_shared<MeasureOptions>();
    CLI::App* verb = app.add_subcommand(
        "measure", "angle of repose, packing and contacts of another program's grains");
    verb->add_option("FILE", o->input.path,
                     "dump of LAMMPS or LIGGGHTS, LAMMPS data, CSV, EDEM's CSV, MercuryDPM's "
                     ".data, Yade's text")
        ->required();
    verb->add_option("--format", o->input.format,
                     "lammps_dump, lammps_data, edem_csv, csv, mercury_data, yade_text; told by "
                     "the first line otherwise");
    add_grain_input(*verb, o->input);
    verb->add_option("--base-diameter", o->base_diameter,
                     "of the disc on which the heap stands; without it no angles");
    verb->add_option("--base-centre", o->base_centre, "x,y of its axis, each with its unit")
        ->type_name("X,Y")
        ->capture_default_str();
    verb->add_option("--base-height", o->base_height, "of its top")->capture_default_str();
    verb->add_option("--up", o->up, "the axis that points up in the file")
        ->check(CLI::IsMember({"x", "y", "z"}))
        ->capture_default_str();
    verb->add_option("--contact-gap", o->contact_gap,
                     "grains touch where their surfaces are at most this far apart")
        ->capture_default_str();
    verb->add_option("--gravity", o->gravity, "by which rest is judged")->capture_default_str();
    verb->add_option("--profile", o->profile, "write the mean profile as CSV")
        ->type_name("FILE.csv");
    verb->add_option("--json", o->common.json,
                     "write the result as JSON to FILE, or to standard output with -")
        ->type_name("FILE");
    verb->add_option("--report", o->common.report, "write a self-contained HTML page")
        ->type_name("FILE");
    verb->add_flag("--quiet", o->common.quiet, "no table");
    verb->footer(examples);
    return {verb, [=] { return run(*o, command); }};
}

}  // namespace app
