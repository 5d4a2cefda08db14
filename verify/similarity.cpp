// SPDX-License-Identifier: MIT
#include "verify/similarity.hpp"

#include "contact/effective.hpp"
#include "scaling/adhesion.hpp"
#include "scaling/errors.hpp"
#include "scaling/scale_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>

namespace verify {
namespace {

constexpr int paper_seeds =
    6;  // a side: enough for differences well beyond the margins, which is what the scheme is asked for

scaling::ScaleMap map_of(const char* scheme, double h) {
    return scaling::ScaleMap::solve(scaling::named_scheme(scheme), h);
}

PileJob reference_job(const cases::Case& c, const ReferenceHeap& heap, std::uint64_t seed) {
    return {.name = fmt::format("reference-{}", seed),
            .seed = seed,
            .setup = reference_setup(c, heap, seed)};
}

PileJob scaled_job(const std::string& name, const cases::Case& c, const ReferenceHeap& heap,
                   const scaling::ScaleMap& map, std::uint64_t seed) {
    return {.name = fmt::format("{}-{}", name, seed),
            .seed = seed,
            .setup = rigs::scaled(reference_setup(c, heap, seed), map),
            .unit_of_length = map.factor("length"),
            .unit_of_time = map.factor("time")};
}

// What the softened grain of both sides can be trusted for; similar sides have the same findings.
std::vector<scaling::Finding> findings_of(const PileJob& job, const scaling::ScaleMap& map,
                                          double poisson_ratio) {
    const rigs::PileSetup& s = job.setup;
    const scaling::Grain grain{scaling::Length::from_value(s.d),
                               scaling::Density::from_value(s.density),
                               scaling::Pressure::from_value(youngs_modulus(s, poisson_ratio)),
                               poisson_ratio,
                               scaling::Acceleration::from_value(s.gravity),
                               scaling::Length::from_value(s.conditions.drop_height)};
    const auto w = scaling::EnergyPerArea::from_value(s.grains.work_of_adhesion);
    return scaling::predict_adhesion(grain, map, {}, {w, scaling::Of::original}).findings;
}

BitsCheck bits_check(const char* scheme, double h, const PileSample& reference,
                     const PileSample& scaled) {
    return {.scheme = scheme,
            .h = h,
            .grains = static_cast<std::size_t>(reference.grains_on_base),
            .reference = reference.hash,
            .scaled = scaled.hash,
            .equal =
                reference.hash == scaled.hash && reference.grains_on_base == scaled.grains_on_base};
}

// The two controls: a scaled pile with one parameter wrong must not pass as equivalent.
struct Control {
    const char *name, *what_differs;
    double adhesion, friction;  // factors
};
constexpr Control controls[] = {
    {"work of adhesion 30 % too low", "w of the scaled grain times 0.7: must not pass", 0.7, 1.0},
    {"friction 20 % too low",
     "sliding and rolling friction of the scaled grain times 0.8: must not pass", 1.0, 0.8},
};

PileJob control_job(const Control& control, const cases::Case& c, const ReferenceHeap& heap,
                    const scaling::ScaleMap& map, std::uint64_t seed) {
    PileJob job =
        scaled_job(control.adhesion < 1.0 ? "adhesion-low" : "friction-low", c, heap, map, seed);
    job.setup.grains.work_of_adhesion *= control.adhesion;
    job.setup.grains.sliding_friction *= control.friction;
    job.setup.grains.rolling_friction *= control.friction;
    return job;
}

// The scheme `paper` as it is argued: gravity, density and modulus kept, grain and apparatus scaled. E/(rho g d) then falls by
// h, so that the reference must be h times stiffer than the scaled pile; that costs most of a full campaign's time.
struct PaperVariant {
    const char *name, *what_differs;
    std::optional<scaling::Invariant> invariant;  // none: no correction at all
};
constexpr PaperVariant paper_variants[] = {
    {"paper, weight_bond", "modulus and gravity kept; w times h^2 (stress_bond asks for the same)",
     scaling::Invariant::weight_bond},
    {"paper, cohesion_number",
     "modulus and gravity kept; w times h^8/5 (sticking_velocity asks for the same)",
     scaling::Invariant::cohesion_number},
    {"paper, no correction", "modulus and gravity kept; w kept", {}},
};

scaling::ScaleMap paper_map(double h, const PaperVariant& variant) {
    const auto map =
        scaling::ScaleMap::solve(scaling::with_scaled_apparatus(scaling::named_scheme("paper")), h);
    return variant.invariant ? scaling::with_adhesion(map, variant.invariant)
                             : map.with_imposed("work_of_adhesion", scaling::Exponents{});
}

PileJob paper_job(std::size_t variant, const cases::Case& c, const ReferenceHeap& stiff, double h,
                  std::uint64_t seed) {
    PileJob job = scaled_job(fmt::format("paper-{}", variant), c, stiff,
                             paper_map(h, paper_variants[variant]), seed);
    rigs::choose_steps(job.setup);
    return job;
}

// 30: the packing fraction scatters by 0.010 from seed to seed, as much as its margin; angle and coordination need 9 and 3.
int seeds_of(Extent extent) { return extent == Extent::small ? 3 : 30; }

}  // namespace

rigs::PileSetup reference_setup(const cases::Case& c, const ReferenceHeap& heap,
                                std::uint64_t seed) {
    if (!c.scaling || !c.scaling->scaled_work_of_adhesion)
        throw scaling::InvalidInput(
            scaling::mistake(c.path + ": scaling.scaled_surface_energy", "nothing",
                             "must be given to verify a scaled pile",
                             "state the surface energy of the scaled grain, e.g. \"0.19 J/m^2\""));
    const double d = c.grain.diameter.value.value(), density = c.grain.density.value.value();
    const double gravity = c.surroundings.gravity.value(), nu = c.grain.poisson_ratio.value.value();
    const double kept_gravity_w = map_of("kept_gravity", c.scaling->h).factor("work_of_adhesion");
    const contact::Material grain{
        scaling::Pressure::from_value(heap.elasticity * density * gravity * d), nu,
        c.grain.density.value};
    rigs::PileSetup s{};
    s.d = d;
    s.density = density;
    s.gravity = gravity;
    s.grains = {.e_star = contact::e_star(grain, grain).value(),
                .g_star = contact::g_star(grain, grain).value(),
                .work_of_adhesion = c.scaling->scaled_work_of_adhesion->value() / kept_gravity_w,
                .sliding_friction = c.model.value_or("sliding_friction", 0.0),
                .rolling_friction = c.model.value_or("rolling_friction", 0.0),
                .restitution = c.model.value_or("restitution", 1.0)};
    s.walls = s.grains;  // no wall touches this heap
    s.conditions = {.base = rigs::Base::glued_grains,
                    .base_diameter = heap.base * d,
                    .rim_height = d,
                    .grains = heap.grains,
                    .drop_height = heap.drop_height * d,
                    .feed_diameter = heap.feed_diameter * d,
                    .feed_rate = 0.0,
                    .funnel = {}};
    s.conditions.feed_rate = rigs::default_feed_rate(s.conditions, d, gravity);
    cases::Grain one_size = c.grain;
    one_size.sizes.clear();
    one_size.size_distribution.clear();
    rigs::choose_feed(s, one_size, seed);
    rigs::choose_steps(s);
    if (heap.lammps_rules) rigs::take_lammps_rules(s);
    return s;
}

SimilarityResult similarity(const cases::Case& c, Extent extent, std::uint64_t seed,
                            const Campaign& campaign, const ReferenceHeap& heap) {
    const auto start = std::chrono::steady_clock::now();
    SimilarityResult result{};
    result.heap = heap;
    if (campaign.engine != nullptr) result.engine = campaign.engine->name();
    const int seeds = seeds_of(extent);
    const double nu = c.grain.poisson_ratio.value.value(), h = c.scaling ? c.scaling->h : 200.0;
    // A side's seeds are its own: an h that is no power of two starts as the same pile and must not count as a second one.
    const std::uint64_t other = seed + 1000;
    const scaling::ScaleMap exact = map_of("exact", 256.0), kept = map_of("kept_gravity", 256.0),
                            chosen = map_of("kept_gravity", h);

    Plan plan;
    const std::size_t reference =
        plan.add(jobs(seeds, seed, [&](std::uint64_t s) { return reference_job(c, heap, s); }));
    // A claim on our own core: heaps of LAMMPS do not keep their bits (docs/verify.md).
    const bool ask_for_bits = campaign.engine == nullptr;
    std::size_t bits_exact = 0, bits_kept = 0;
    if (ask_for_bits) {
        bits_exact = plan.add({scaled_job("exact-256", c, heap, exact, seed)});
        bits_kept = plan.add({scaled_job("kept_gravity-256", c, heap, kept, seed)});
    }
    const std::size_t scaled = plan.add(jobs(seeds, other, [&](std::uint64_t s) {
        return scaled_job(fmt::format("kept_gravity-{:g}", h), c, heap, chosen, s);
    }));
    // The other schemes that are no distortion: they must do as well.
    constexpr const char* others[] = {"exact", "kept_gravity_kept_modulus"};
    std::vector<std::size_t> other_scheme;
    if (extent == Extent::full)
        for (const char* scheme : others)
            other_scheme.push_back(plan.add(
                jobs(seeds, other + 2000 * (1 + other_scheme.size()), [&](std::uint64_t s) {
                    return scaled_job(fmt::format("{}-{:g}", scheme, h), c, heap, map_of(scheme, h),
                                      s);
                })));
    std::vector<std::size_t> control;
    if (extent == Extent::full)
        for (const Control& k : controls)
            control.push_back(plan.add(jobs(seeds, other + 1000, [&](std::uint64_t s) {
                return control_job(k, c, heap, chosen, s);
            })));
    ReferenceHeap stiff = heap;
    stiff.elasticity *= h;
    std::vector<std::size_t> paper;
    if (extent == Extent::full) {
        paper.push_back(plan.add(jobs(paper_seeds, seed + 5000, [&](std::uint64_t s) {
            PileJob job = reference_job(c, stiff, s);
            job.name = fmt::format("stiff-reference-{}", s);
            return job;
        })));
        for (std::size_t k = 0; k < std::size(paper_variants); ++k)
            paper.push_back(plan.add(jobs(paper_seeds, seed + 6000, [&](std::uint64_t s) {
                return paper_job(k, c, stiff, h, s);
            })));
    }
    plan.run(campaign);

    const auto side = [&](const std::string& label, std::size_t group) {
        Side result_side = side_of(label, plan.job(group), nu);
        result_side.samples = plan.samples(group);
        return result_side;
    };
    if (ask_for_bits)
        result.bits = {bits_check("exact", 256.0, plan.samples(reference).front(),
                                  plan.samples(bits_exact).front()),
                       bits_check("kept_gravity", 256.0, plan.samples(reference).front(),
                                  plan.samples(bits_kept).front())};
    result.findings = findings_of(plan.job(reference), chosen, nu);
    const Side reference_side = side("reference", reference);
    result.comparisons.push_back(compare(fmt::format("kept_gravity, h = {:g}", h),
                                         "the scale alone", reference_side, side("scaled", scaled),
                                         result.margins));
    for (std::size_t k = 0; k < other_scheme.size(); ++k)
        result.comparisons.push_back(compare(fmt::format("{}, h = {:g}", others[k], h),
                                             "the scale alone", reference_side,
                                             side("scaled", other_scheme[k]), result.margins));
    for (std::size_t k = 0; k < control.size(); ++k) {
        result.comparisons.push_back(compare(controls[k].name, controls[k].what_differs,
                                             reference_side, side("scaled, off", control[k]),
                                             result.margins));
        result.comparisons.back().must_differ = true;
    }
    for (std::size_t k = 1; k < paper.size(); ++k)
        result.comparisons.push_back(compare(paper_variants[k - 1].name,
                                             paper_variants[k - 1].what_differs,
                                             side("reference, modulus kept", paper.front()),
                                             side("scaled", paper[k]), result.margins));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    result.seconds = seconds.count();
    return result;
}

}  // namespace verify
