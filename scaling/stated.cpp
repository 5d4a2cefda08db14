// SPDX-License-Identifier: MIT
#include "scaling/stated.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scaling {

namespace {

Judgement within(double ratio, double tolerance) {
    return std::abs(ratio - 1.0) <= tolerance ? Judgement::fine : Judgement::caution;
}

// A third figure is the least that a published step should carry.
constexpr double step_tolerance = 0.005;
// "About 1e5" may be 0.7e5 or 1.5e5.
constexpr double count_tolerance = 0.5;
// Times are given to one or two figures.
constexpr double time_tolerance = 0.05;

void check_time_step(std::vector<Finding>& findings, const StatedCounts& stated,
                     const CostInput& scaled) {
    if (!stated.time_step) return;
    const Cost computed = cost(scaled);
    const double ratio = Dimensionless(*stated.time_step / computed.time_step).value();
    findings.push_back(
        {"stated_time_step_over_computed", ratio, "= 1 +- 0.005", within(ratio, step_tolerance),
         fmt::format("{:.3g} s is stated, {:g} of the Rayleigh time is {:.4g} s; the stated one is "
                     "{:.2f} % of the Rayleigh time",
                     stated.time_step->value(), scaled.rayleigh_fraction,
                     computed.time_step.value(), 100.0 * ratio * scaled.rayleigh_fraction)});
}

void check_counts(std::vector<Finding>& findings, const StatedCounts& stated,
                  double originals_per_grain) {
    if (stated.grains.empty()) return;
    const auto [least, most] = std::minmax_element(stated.grains.begin(), stated.grains.end());
    if (stated.grains.size() > 1) {
        const double apart = *most / *least;
        findings.push_back(
            {"stated_grain_counts_apart", apart, "= 1 +- 0.5", within(apart, count_tolerance),
             fmt::format("the same simulation is said to have {:.3g} and {:.3g} grains", *least,
                         *most)});
    }
    if (stated.original_grains) {
        const double represented = stated.grains.front() * originals_per_grain;
        const double ratio = *stated.original_grains / represented;
        findings.push_back(
            {"stated_originals_over_represented", ratio, "= 1 +- 0.5",
             within(ratio, count_tolerance),
             fmt::format("{:.3g} originals are stated, but {:.3g} scaled grains stand for {:.3g} "
                         "({:.3g} each)",
                         *stated.original_grains, stated.grains.front(), represented,
                         originals_per_grain)});
    }
}

void check_times(std::vector<Finding>& findings, const StatedCounts& stated) {
    if (!stated.simulated_time || !stated.feed_rate || stated.grains.empty()) return;
    const Time feeding = stated.grains.front() / *stated.feed_rate;
    const Time needed = stated.settling_time ? feeding + *stated.settling_time : feeding;
    const double ratio = Dimensionless(*stated.simulated_time / needed).value();
    findings.push_back(
        {"stated_time_over_feed_and_settling", ratio, "= 1 +- 0.05", within(ratio, time_tolerance),
         fmt::format("{:.3g} s is stated, feeding takes {:.3g} s and with settling {:.3g} s",
                     stated.simulated_time->value(), feeding.value(), needed.value())});
}

void check_speed(std::vector<Finding>& findings, const StatedCounts& stated,
                 const CostInput& scaled) {
    if (!stated.wall_time || !stated.simulated_time || stated.grains.empty() ||
        !scaled.grain_steps_per_second)
        return;
    const Time step = stated.time_step ? *stated.time_step : cost(scaled).time_step;
    const double steps = Dimensionless(*stated.simulated_time / step).value();
    const double implied = stated.grains.front() * steps / stated.wall_time->value();
    const double ratio = implied / *scaled.grain_steps_per_second;
    findings.push_back(
        {"implied_speed_over_measured", ratio, "<= 1",
         ratio <= 1.0 ? Judgement::fine : Judgement::caution,
         fmt::format(
             "{:.3g} grain steps per second follow from the wall time stated (fewer while the "
             "heap is still being fed), {:.3g} were measured",
             implied, *scaled.grain_steps_per_second)});
}

void check_volume(std::vector<Finding>& findings, const StatedCounts& stated,
                  const CostInput& scaled) {
    if (!stated.heap || stated.grains.empty()) return;
    const Heap& heap = *stated.heap;
    const double ratio = stated.grains.front() / grains_in(heap, scaled.grain.diameter);
    findings.push_back(
        {"packing_to_cover_base_over_measured", ratio, ">= 1",
         ratio >= 1.0 ? Judgement::fine : Judgement::caution,
         fmt::format(
             "{:.3g} grains fill a cone of {:.3g} cm^3 at packing {:.3f} with none falling off; "
             "the powder has {:.3f}{}",
             stated.grains.front(), 1e6 * heap_volume(heap).value(), ratio * heap.packing_fraction,
             heap.packing_fraction,
             ratio >= 1.0 ? "" : ", so the base was not covered or the heap is looser")});
}

}  // namespace

std::vector<Finding> stated_findings(const StatedCounts& stated, const CostInput& scaled,
                                     double originals_per_grain) {
    std::vector<Finding> findings;
    check_time_step(findings, stated, scaled);
    check_counts(findings, stated, originals_per_grain);
    check_times(findings, stated);
    check_speed(findings, stated, scaled);
    check_volume(findings, stated, scaled);
    return findings;
}

}  // namespace scaling
