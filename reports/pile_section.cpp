// SPDX-License-Identifier: MIT
#include "reports/numbers.hpp"
#include "reports/runs.hpp"
#include "reports/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reports {

namespace {

// z of the profile at `r`; NaN outside of it.
double height_at(const HeapProfile& p, double r) {
    if (p.r.empty() || r < p.r.front() || r > p.r.back()) return std::nan("");
    const auto above =
        static_cast<std::size_t>(std::lower_bound(p.r.begin(), p.r.end(), r) - p.r.begin());
    if (above == 0) return p.z.front();
    const double share = (r - p.r[above - 1]) / (p.r[above] - p.r[above - 1]);
    return p.z[above - 1] + share * (p.z[above] - p.z[above - 1]);
}

struct Envelope {
    Curve mean;
    Band band;
};

Envelope envelope(const HeapGroup& group, int style) {
    Envelope e;
    e.mean = {.x = group.profiles.front().r, .y = {}, .style = style, .label = group.label};
    e.band = {.x = e.mean.x, .low = {}, .high = {}, .style = style, .label = ""};
    for (const double r : e.mean.x) {
        double sum = 0.0, low = INFINITY, high = -INFINITY;
        for (const HeapProfile& p : group.profiles) {
            const double z = height_at(p, r);
            sum += z;
            low = std::min(low, z);
            high = std::max(high, z);
        }
        const bool all = std::isfinite(sum);
        e.mean.y.push_back(sum / static_cast<double>(group.profiles.size()));
        e.band.low.push_back(all ? low : std::nan(""));
        e.band.high.push_back(all ? high : std::nan(""));
    }
    return e;
}

std::string description(const std::vector<HeapGroup>& groups) {
    std::string text =
        "Mean height of the heap against the distance from its axis, both in grain diameters.";
    for (const HeapGroup& g : groups) {
        if (g.profiles.empty()) continue;
        double top = 0.0;
        for (const double z : g.profiles.front().z) top = std::max(top, z);
        text += fmt::format(" {}: {} high in the first of {} runs.", g.label, number(top),
                            g.profiles.size());
    }
    return text;
}

HeapProfile profile_in_diameters(const rigs::RadialProfile& profile, double d) {
    HeapProfile p;
    for (const double r : profile.r) p.r.push_back(r / d);
    for (const double z : profile.z) p.z.push_back(z / d);
    return p;
}

std::string packing_words(const std::optional<double>& packing) {
    return packing ? number(*packing) : "not to be had (too small a heap)";
}

}  // namespace

Figure profile_figure(const std::vector<HeapGroup>& groups, const std::string& id) {
    Plot plot;
    plot.title = "Heap profiles";
    plot.description = description(groups);
    plot.x = {.label = "distance from the axis, r / d"};
    plot.y = {.label = "height, z / d"};
    plot.equal_scale = true;
    double widest = 0.0, highest = 0.0;
    for (const HeapGroup& group : groups)
        for (const HeapProfile& p : group.profiles) {
            for (const double r : p.r) widest = std::max(widest, r);
            for (const double z : p.z) highest = std::max(highest, z);
        }
    if (widest > 0.0 && highest > 0.0) {
        plot.x.range = {0.0, 1.02 * widest};
        plot.y.range = {0.0, 1.06 * highest};
    }
    bool bands = false;
    int style = 0;
    for (const HeapGroup& group : groups) {
        if (group.profiles.empty()) continue;
        Envelope e = envelope(group, style++);
        plot.curves.push_back(std::move(e.mean));
        if (group.profiles.size() < 2) continue;
        plot.bands.push_back(std::move(e.band));
        bands = true;
    }
    return {svg(plot, id), bands ? "Lines: mean over the seeds. Shaded: lowest to highest of the "
                                   "seeds. Both axes have one scale."
                                 : "Mean over all azimuths. Both axes have one scale."};
}

std::string failed_criteria(const rigs::Formed& formed) {
    std::string failed;
    for (const rigs::Criterion& c : formed.criteria)
        if (!c.pass)
            failed += fmt::format("{}{} is {}, must be {}", failed.empty() ? "" : "; ",
                                  words(c.name), number(c.value), c.rule);
    return failed;
}

TextTable angle_table(
    const std::vector<std::pair<rigs::Estimator, std::optional<rigs::Angle>>>& angles) {
    TextTable table = {{"angle of repose by", "degrees", "spread", "sectors or views"}};
    for (const auto& [estimator, angle] : angles)
        table.push_back({rigs::to_string(estimator), angle ? degrees(angle->angle) : "none",
                         angle ? degrees(angle->spread) : "",
                         angle ? fmt::format("{}", angle->samples) : ""});
    return table;
}

RunSection pile_section(const std::string& name, const rigs::PileRecord& record) {
    const std::string failed = failed_criteria(record.formed);
    Verdict verdict{Answer::yes, "A heap formed and came to rest",
                    "every criterion of a heap is met"};
    if (!record.at_rest)
        verdict = {Answer::cannot_tell, "Still moving when the run was given up", failed};
    else if (!record.formed.formed)
        verdict = {Answer::no, "No heap formed", failed};
    RunSection section{
        name,
        verdict,
        {},
        profile_figure({{name, {profile_in_diameters(record.profile, record.grain_diameter)}}},
                       "profile-" + name),
        angle_table(record.angles),
        {}};
    section.notes.push_back(fmt::format(
        "{} grains fed, {} fell off; packing fraction {}, {} contacts per grain; {} steps",
        count(static_cast<double>(record.grains_fed)),
        count(static_cast<double>(record.grains_lost)), packing_words(record.packing_fraction),
        number(record.coordination), count(static_cast<double>(record.steps))));
    if (record.heap.spheres > 1)
        section.notes.push_back(
            fmt::format("each grain is a clump of {} spheres, {} times as long as it is wide",
                        record.heap.spheres, number(record.aspect_ratio)));
    if (record.grains_in_funnel > 0)
        section.notes.push_back(fmt::format(
            "{} grains are still held by the funnel; they are no part of the heap, its angles and "
            "its packing",
            count(static_cast<double>(record.grains_in_funnel))));
    if (record.work.slept > 0)
        section.notes.push_back(fmt::format(
            "sleep left out {} % of {} grain-steps, {} % of those while the heap was fed; without "
            "--sleep the heap is another draw from the same chance",
            number(100.0 * record.work.share_slept()),
            count(static_cast<double>(record.work.asked)),
            number(100.0 * record.work_while_fed.share_slept())));
    section.notes.insert(section.notes.end(), record.notes.begin(), record.notes.end());
    return section;
}

RunSection heap_section(const std::string& name, const rigs::Measured& m) {
    RunSection section{
        name, {Answer::yes, "Grains and contacts; no angles", "no base is stated"}, {}, {}, {}, {}};
    section.notes.push_back(
        fmt::format("{} grains in the heap, {} fixed, {} below the base, {} beyond its rim",
                    m.loose, m.fixed, m.below_base, m.beyond_rim));
    section.notes.push_back(
        fmt::format("diameter {} on average, {} to {}; {} contacts per grain by geometry, largest "
                    "overlap {} of R*",
                    quantity(m.mean, "m"), quantity(m.smallest, "m"), quantity(m.largest, "m"),
                    number(m.contacts.coordination), number(m.contacts.largest_overlap)));
    if (!m.heap) return section;
    const std::string failed = failed_criteria(m.heap->formed);
    section.verdict = m.heap->formed.formed ? Verdict{Answer::yes, "A heap formed",
                                                      "every criterion of a heap is met"}
                                            : Verdict{Answer::no, "No heap formed", failed};
    section.figure =
        profile_figure({{name, {profile_in_diameters(m.heap->profile, m.mean)}}}, "profile");
    section.quantities = angle_table(m.heap->angles);
    section.notes.push_back(
        "packing fraction " +
        packing_words(m.heap->packing ? std::optional(m.heap->packing->value) : std::nullopt));
    return section;
}

}  // namespace reports
