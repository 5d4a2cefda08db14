// SPDX-License-Identifier: MIT
#include "app/bench_bars.hpp"
#include "app/bench_results.hpp"
#include "reports/numbers.hpp"
#include "reports/svg.hpp"
#include "reports/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace app {

using reports::TextTable;

namespace {

constexpr double mega = 1e6, giga = 1e9, nano = 1e-9;

std::string spread_text(const bench::Spread& s, double unit = 1.0) {
    return fmt::format("{:.3g} [{:.3g}, {:.3g}]", s.median / unit, s.low / unit, s.high / unit);
}

bench::Spread speed_of(const bench::Comparison& c, const bench::Timed& e) {
    return bench::spread_of(bench::speeds(c.bed, e));
}

std::vector<const bench::Timed*> all_of(const bench::Comparison& c) {
    std::vector<const bench::Timed*> all = {&c.ours};
    for (const bench::Timed& peer : c.peers) all.push_back(&peer);
    return all;
}

TextTable table_of(const bench::Comparison& c) {
    TextTable t = {
        {"engine", "M grain-steps/s", "ours / theirs", "neighbours", "E_kin, J", "version"}};
    for (const bench::Timed* e : all_of(c))
        t.push_back({e->title, spread_text(speed_of(c, *e), mega),
                     e == &c.ours ? "" : spread_text(bench::spread_of(bench::ratios(c.ours, *e))),
                     fmt::format("{:.3f}", e->runs.back().neighbours),
                     reports::number(e->runs.back().kinetic_energy), e->version});
    return t;
}

std::string what_ran(const bench::Comparison& c) {
    return fmt::format(
        "{} x {} x {} spheres of R = {}, {} steps of warm-up, {} timed, {} {}, {} {}", c.bed.nx,
        c.bed.ny, c.bed.nz, reports::quantity(c.bed.radius, "m"), c.bed.warm_up, c.bed.steps,
        c.threads, c.threads == 1 ? "thread" : "threads or ranks", c.ours.runs.size(),
        c.ours.runs.size() == 1 ? "run of each" : "runs of each in turn");
}

std::vector<std::string> notes_of(const bench::Comparison& c) {
    std::vector<std::string> notes = {
        "Median [lowest, highest] of the runs; ours / theirs is taken run by run. "
        "Neighbours: overlapping grains per grain at the end, counted alike for all. Every engine "
        "starts from the same positions, to the last bit."};
    for (const bench::Timed* e : all_of(c))
        notes.push_back(fmt::format("{}: {}{}.", e->title, e->laws,
                                    e->differs.empty() ? "" : "; " + e->differs));
    for (const bench::Timed& peer : c.peers)
        notes.push_back(fmt::format("{}: cd {} && {}", peer.title, peer.folder, peer.command));
    return notes;
}

TextTable table_of(const bench::ScalingStudy& s) {
    TextTable t = {{"grains", "threads", "ns per grain-step", "contacts/grain", "B/grain",
                    "B/contact", "moved, B", "moved, GB/s", "triad, GB/s"}};
    for (const bench::ScalingPoint& p : s.points)
        t.push_back({reports::count(p.grains), fmt::format("{}", p.threads),
                     spread_text(p.grain_step, nano), reports::number(p.contacts),
                     reports::number(p.bytes_per_grain()), reports::number(p.bytes_per_contact()),
                     reports::number(p.moved()),
                     reports::number(p.moved() / p.grain_step.median / giga),
                     reports::number(p.triad / giga)});
    return t;
}

const char* scaling_note =
    "Cubic lattices in contact, at rest; each contact counted once. Moved: what a step must read "
    "and write at least, once each, per grain and step; triad: STREAM's, over arrays as large in "
    "all as the simulation.";

TextTable table_of(const bench::PolydisperseStudy& p) {
    TextTable t = {{"bed", "grains", "contacts/grain", "ns per contact-step", "ns per grain-step"}};
    const auto row = [&](const char* name, const bench::PolydisperseSide& s) {
        t.push_back({name, reports::count(s.grains), reports::number(s.contacts),
                     spread_text(s.contact_step, nano), spread_text(s.grain_step, nano)});
    };
    row("one size", p.equal);
    row("sizes 1 to 10", p.mixed);
    return t;
}

std::string note_of(const bench::PolydisperseStudy& p) {
    return fmt::format(
        "A contact of the mixed bed costs {:.3g} times one of the bed of one size ({} "
        "threads).",
        p.ratio(), p.threads);
}

std::string triad_text(const bench::Triad& t) {
    return fmt::format("STREAM triad, {:.0f} MB, {} {}: {:.3g} GB/s", t.bytes / mega, t.threads,
                       t.threads == 1 ? "thread" : "threads", t.bandwidth / giga);
}

std::string columns(const TextTable& t) {
    std::vector<bool> right(t.front().size(), true);
    right.front() = false;
    if (t.front().back() == "version") right.back() = false;
    return reports::columns(t, right);
}

std::string wrapped(const std::string& text) { return "  " + reports::wrapped(text, 98, 2) + "\n"; }

// --- sections ---------------------------------------------------------------------------------

std::string busy_text(const bench::Machine& m) {
    return fmt::format(
        "the machine was busy before the start (load {:.2f} on {} cores); wait, and repeat",
        m.load_before, m.cores);
}

// What was measured on a busy machine decides nothing.
reports::Verdict qualified(reports::Verdict v, const bench::Machine& machine) {
    if (!bench::busy(machine)) return v;
    v.answer = reports::Answer::cannot_tell;
    v.why += "; not to be quoted: " + busy_text(machine);
    return v;
}

reports::Verdict verdict_of(const bench::Comparison& c) {
    const bench::Spread ours = speed_of(c, c.ours);
    const std::string speed = fmt::format("{} million grain-steps/s on {} threads",
                                          reports::number(ours.median / mega), c.threads);
    if (c.peers.empty())
        return {reports::Answer::cannot_tell, speed,
                "no other engine was found on this machine, so there is nothing to compare with"};
    const bench::Timed& peer = c.peers.front();
    const bench::Spread r = bench::spread_of(bench::ratios(c.ours, peer));
    const auto answer = r.low > 1.0    ? reports::Answer::yes
                        : r.high < 1.0 ? reports::Answer::no
                                       : reports::Answer::cannot_tell;
    return {answer,
            fmt::format("{} times the speed of {}",
                        reports::number(std::round(100.0 * r.median) / 100.0), peer.title),
            fmt::format("{}; from {:.3g} to {:.3g} over {} runs in turn", speed, r.low, r.high,
                        c.ours.runs.size())};
}

reports::RunSection section_of(const bench::Comparison& c, const bench::Machine& machine) {
    std::vector<Bar> bars;
    for (const bench::Timed* e : all_of(c)) {
        const bench::Spread s = speed_of(c, *e);
        bars.push_back(
            {e->title, s.median / mega, s.low / mega, s.high / mega, e == &c.ours ? 0 : 1});
    }
    return {what_ran(c),
            qualified(verdict_of(c), machine),
            notes_of(c),
            {bars_svg("Speed on the bed", "million grain-steps per second", bars, "bench-speed"),
             "Median of the runs, and the lowest and the highest."},
            table_of(c),
            {}};
}

reports::Figure figure_of(const bench::ScalingStudy& s) {
    std::vector<int> teams;
    for (const bench::ScalingPoint& p : s.points)
        if (std::find(teams.begin(), teams.end(), p.threads) == teams.end())
            teams.push_back(p.threads);
    reports::Plot plot{"Cost of a grain-step",
                       "Wall time per grain and step as the bed grows.",
                       {"log10 of the number of grains"},
                       {"ns per grain-step"},
                       {},
                       {}};
    for (std::size_t t = 0; t < teams.size(); ++t) {
        reports::Curve curve{{},
                             {},
                             static_cast<int>(t),
                             fmt::format("{} {}", teams[t], teams[t] == 1 ? "thread" : "threads")};
        for (const bench::ScalingPoint& p : s.points)
            if (p.threads == teams[t]) {
                curve.x.push_back(std::log10(p.grains));
                curve.y.push_back(p.grain_step.median / nano);
            }
        plot.curves.push_back(curve);
        curve.marked = true;
        curve.label.clear();
        plot.curves.push_back(curve);
    }
    return {reports::svg(plot, "bench-scaling"), "Median of the repeats."};
}

reports::Verdict verdict_of(const bench::ScalingStudy& s) {
    const bench::ScalingPoint& p = s.points.back();
    return {
        reports::Answer::yes,
        fmt::format("{} ns per grain-step at {} grains",
                    reports::number(p.grain_step.median / nano), reports::count(p.grains)),
        fmt::format("{} threads, {} contacts per grain", p.threads, reports::number(p.contacts))};
}

reports::Verdict verdict_of(const bench::PolydisperseStudy& p) {
    return {reports::Answer::yes,
            fmt::format("{:.3g} times the cost of a contact among equal grains", p.ratio()),
            "sizes 1 to 10 against one size, the same number of grains"};
}

}  // namespace

std::string text_of(const BenchResults& r) {
    std::string text = fmt::format("{}, {} cores, load before {:.2f}\n", r.machine.processor,
                                   r.machine.cores, r.machine.load_before);
    if (bench::busy(r.machine)) text += "NOT TO BE QUOTED: " + busy_text(r.machine) + "\n";
    if (r.comparison) {
        text += what_ran(*r.comparison) + "\n" + columns(table_of(*r.comparison));
        for (const std::string& note : notes_of(*r.comparison)) text += wrapped(note);
        if (r.comparison->peers.empty())
            text += wrapped("No other engine was found; apt-get install lammps liggghts.");
    }
    if (r.scaling) text += columns(table_of(*r.scaling)) + wrapped(scaling_note);
    if (r.polydisperse)
        text += columns(table_of(*r.polydisperse)) + wrapped(note_of(*r.polydisperse));
    for (const bench::Triad& t : r.triads) text += wrapped(triad_text(t));
    return text;
}

std::vector<reports::RunSection> sections_of(const BenchResults& r) {
    std::vector<reports::RunSection> all;
    if (r.comparison) all.push_back(section_of(*r.comparison, r.machine));
    if (r.scaling)
        all.push_back({"Cost as the bed grows",
                       qualified(verdict_of(*r.scaling), r.machine),
                       {scaling_note},
                       figure_of(*r.scaling),
                       table_of(*r.scaling),
                       {}});
    if (r.polydisperse)
        all.push_back({"Grains of two sizes",
                       qualified(verdict_of(*r.polydisperse), r.machine),
                       {note_of(*r.polydisperse)},
                       {},
                       table_of(*r.polydisperse),
                       {}});
    for (const bench::Triad& t : r.triads)
        if (!all.empty()) all.back().notes.push_back(triad_text(t) + ".");
    return all;
}

reports::Verdict verdict_of(const BenchResults& r) {
    return qualified(r.comparison ? verdict_of(*r.comparison)
                     : r.scaling  ? verdict_of(*r.scaling)
                                  : verdict_of(*r.polydisperse),
                     r.machine);
}

std::vector<std::string> limits_of(const BenchResults& r) {
    std::vector<std::string> limits = {
        fmt::format(
            "One machine ({}, {} cores, load {:.2f} before the start). Speeds move with what "
            "else runs; only ratios of neighbouring runs hold.",
            r.machine.processor, r.machine.cores, r.machine.load_before),
        "One bed: other packings, softer or faster grains make other lists and other contacts."};
    if (r.comparison)
        limits.emplace_back(
            "Each engine runs as its Debian package was built; a build for this processor may be "
            "faster, and so may ours.");
    return limits;
}

}  // namespace app
