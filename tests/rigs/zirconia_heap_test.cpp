// SPDX-License-Identifier: MIT
// The zirconia heap on the 50 mm base at h = 1000 (docs/heap-50mm.md): the case files hold together. Nothing is run here.
#include "cases/read_case.hpp"
#include "rigs/pile.hpp"
#include "scaling/adhesion.hpp"
#include "scaling/schemes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace {

const std::string at_1000 = "data/zirconia/heap-50mm.json",
                  at_200 = "data/zirconia/heap-50mm-h200.json",
                  kept_adhesion = "data/zirconia/heap-50mm-kept-adhesion.json";

const cases::Experiment& experiment(const cases::Case& c, const std::string& id) {
    const auto found = std::find_if(c.experiments.begin(), c.experiments.end(),
                                    [&](const cases::Experiment& e) { return e.id == id; });
    REQUIRE(found != c.experiments.end());
    return *found;
}

double volume(const rigs::PileSetup& s) {  // m^3 of all grains
    double sum = 0.0;
    for (const double r : s.radius) sum += 4.0 / 3.0 * std::numbers::pi * r * r * r;
    return sum;
}

}  // namespace

TEST_CASE("the heap at h = 1000 has the material that the paper's grain has under `scale`",
          "[rigs][pile][zirconia]") {
    const cases::Case fine = cases::read_case(at_200), coarse = cases::read_case(at_1000);
    REQUIRE(fine.scaling);
    const cases::Experiment &small = fine.experiments.at(0), &big = coarse.experiments.at(0);
    const scaling::Grain grain{
        small.grain.diameter.value,       small.grain.density.value,
        small.grain.youngs_modulus.value, small.grain.poisson_ratio.value.value(),
        small.surroundings.gravity,       {}};
    const auto map =
        scaling::ScaleMap::solve(scaling::named_scheme(fine.scaling->scheme), fine.scaling->h);
    const auto w = scaling::EnergyPerArea::from_value(0.38);  // 2 x 0.19, Table 11
    CHECK(fine.model.value_or("work_of_adhesion", 0.0) == Approx(w.value()).epsilon(1e-12));
    const auto predicted = scaling::predict_adhesion(
        grain, map, scaling::invariant_from(fine.scaling->invariant), {w, scaling::Of::original});
    // Digits as the files print them.
    CHECK(coarse.model.value_or("work_of_adhesion", 0.0) ==
          Approx(predicted.scaled.work_of_adhesion.value()).epsilon(1e-9));
    CHECK(big.grain.diameter.value.value() ==
          Approx(small.grain.diameter.value.value() * map.factor("length")).epsilon(1e-12));
    CHECK(big.grain.youngs_modulus.value.value() ==
          Approx(small.grain.youngs_modulus.value.value() * map.factor("youngs_modulus"))
              .epsilon(1e-12));
    for (const char* name : {"restitution", "sliding_friction", "rolling_friction",
                             "wall_restitution", "wall_sliding_friction", "wall_rolling_friction"})
        CHECK(coarse.model.value_or(name, -1.0) == fine.model.value_or(name, -2.0));
}

TEST_CASE("the experiments of the heap at h = 1000 can be set up", "[rigs][pile][zirconia]") {
    const cases::Case c = cases::read_case(at_1000);
    for (const char* id : {"spill", "paper_mass", "outlet_6mm"}) {
        INFO(id);
        const rigs::PileSetup s = rigs::pile_setup(c, experiment(c, id), 1);
        CHECK(s.conditions.base == rigs::Base::flat);
        CHECK(s.conditions.base_diameter == Approx(0.05).epsilon(1e-12));
        CHECK(s.d == Approx(1.2e-3).epsilon(1e-12));
        CHECK(s.walls.work_of_adhesion == 0.0);  // section 4.1
        // 0.2 of the Rayleigh time of R = 0.6 mm: 0.2 pi R sqrt(rho/G) / 0.92553.
        const double rayleigh = 0.2 * std::numbers::pi * 0.6e-3 * std::sqrt(5600 / 60e6) / 0.92553;
        CHECK(s.time_step <= rayleigh * (1.0 + 1e-6));
        CHECK(s.time_step > 0.5 * rayleigh);
    }
}

TEST_CASE("the heap with its adhesion kept is the same but for w", "[rigs][pile][zirconia]") {
    const cases::Case scaled = cases::read_case(at_1000), kept = cases::read_case(kept_adhesion);
    CHECK(kept.model.value_or("work_of_adhesion", 0.0) == Approx(0.38).epsilon(1e-12));
    for (const char* id : {"spill", "paper_mass"}) {
        INFO(id);
        const rigs::PileSetup a = rigs::pile_setup(scaled, experiment(scaled, id), 1);
        const rigs::PileSetup b = rigs::pile_setup(kept, experiment(kept, id), 1);
        CHECK(b.radius == a.radius);
        CHECK(b.density == a.density);
        CHECK(b.time_step == a.time_step);
        CHECK(b.conditions.base_diameter == a.conditions.base_diameter);
        CHECK(b.conditions.drop_height == a.conditions.drop_height);
        CHECK(b.conditions.feed_diameter == a.conditions.feed_diameter);
        CHECK(b.conditions.feed_rate == a.conditions.feed_rate);
    }
    for (const char* name : {"restitution", "sliding_friction", "rolling_friction",
                             "wall_restitution", "wall_sliding_friction", "wall_rolling_friction"})
        CHECK(kept.model.value_or(name, -1.0) == scaled.model.value_or(name, -2.0));
}

TEST_CASE("the heap at h = 1000 is fed as a dilute rain from the width of the paper's outlet",
          "[rigs][pile][zirconia]") {
    const cases::Case c = cases::read_case(at_1000);
    for (const char* id : {"spill", "paper_mass"}) {
        INFO(id);
        const rigs::PileSetup s = rigs::pile_setup(c, experiment(c, id), 1);
        double farthest = 0.0;
        for (std::size_t k = 0; k < s.radius.size(); ++k)
            farthest = std::max(farthest, std::hypot(s.feed_x[k], s.feed_y[k]) + s.radius[k]);
        CHECK(farthest <= 3e-3 * (1.0 + 1e-12));
        CHECK(farthest > 2.9e-3);  // 8000 draws over the disc reach its edge
        const double speed = std::sqrt(2.0 * s.gravity * 65e-3);
        const double stream = std::numbers::pi * 3e-3 * 3e-3 * speed;  // m^3/s
        const double count = static_cast<double>(s.radius.size());
        const double share = volume(s) / count * s.conditions.feed_rate / stream;
        CHECK(share < 0.06);
        CHECK(share > 0.01);
    }
}

TEST_CASE("the paper's mass is the same at h = 200 and h = 1000", "[rigs][pile][zirconia]") {
    const cases::Case fine = cases::read_case(at_200), coarse = cases::read_case(at_1000);
    const rigs::PileSetup small = rigs::pile_setup(fine, experiment(fine, "paper_mass"), 1),
                          big = rigs::pile_setup(coarse, experiment(coarse, "paper_mass"), 1);
    CHECK(small.radius.size() == 1000000);
    CHECK(big.radius.size() == 8000);
    CHECK(volume(big) * big.density == Approx(volume(small) * small.density).epsilon(1e-9));
    CHECK(big.conditions.base_diameter == small.conditions.base_diameter);
    CHECK(big.conditions.drop_height == small.conditions.drop_height);
    CHECK(big.conditions.feed_diameter == small.conditions.feed_diameter);
}

TEST_CASE("the paper's outlet is five grains wide at h = 1000", "[rigs][pile][zirconia]") {
    const cases::Case c = cases::read_case(at_1000), paper = cases::read_case("data/zirconia");
    const rigs::PileConditions ours = rigs::pile_conditions(experiment(c, "outlet_6mm"));
    REQUIRE(ours.funnel);
    CHECK(ours.funnel->outlet_diameter ==
          Approx(5.0 * c.experiments.at(0).grain.diameter.value.value()).epsilon(1e-12));
    const cases::Value& theirs = paper.experiments.at(0).conditions.at("funnel");
    const auto length = [&](const char* key) {
        return theirs.at(key).quantity<scaling::Length>().value();
    };
    CHECK(ours.funnel->outlet_diameter == length("outlet_diameter"));
    CHECK(ours.funnel->top_diameter == length("top_diameter"));
    CHECK(ours.funnel->height == length("height"));
    CHECK(ours.funnel->outlet_height == length("outlet_height"));
}
