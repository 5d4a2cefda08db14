// SPDX-License-Identifier: MIT
#include "scaling/cost.hpp"

#include "scaling/errors.hpp"
#include "scaling/numbers.hpp"
#include "scaling/scale_number.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace scaling;

namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

const Grain zirconia = {.diameter = 1.2e-6 * si::meters,
                        .density = 5600.0 * si::kilogrammes_per_cubic_metre,
                        .youngs_modulus = youngs_modulus(60e6 * si::pascals, 0.3),
                        .poisson_ratio = 0.3,
                        .gravity = 9.81 * si::meters_per_second_squared,
                        .drop_height = std::nullopt};

CostInput input() { return {zirconia, 8e12, 12.0 * si::seconds, 0.2, 1e7}; }

ScaleMap map_of(const char* scheme, double h = 200.0) {
    return ScaleMap::solve(named_scheme(scheme), h);
}

}  // namespace

TEST_CASE("scale number: the paper's outlet and grain go from 10000, macro, to 50, micro",
          "[scale number][paper]") {
    const Length outlet = 6e-3 * si::meters, d = 1.2e-6 * si::meters;
    const ScaleNumber before = scale_number(outlet, d),
                      after = scaled_scale_number(outlet, d, map_of("paper"));
    REQUIRE(before.value == Approx(10000.0).epsilon(1e-12));
    REQUIRE(before.size_class == SizeClass::macro);
    REQUIRE(after.value == Approx(50.0).epsilon(1e-12));
    REQUIRE(after.size_class == SizeClass::micro);
}

TEST_CASE("scale number: where the apparatus grows along it stays, to the last bit",
          "[scale number]") {
    const Length outlet = 6e-3 * si::meters, d = 1.2e-6 * si::meters;
    for (const char* scheme : {"exact", "kept_gravity", "kept_gravity_kept_modulus"}) {
        REQUIRE(scaled_scale_number(outlet, d, map_of(scheme)).value ==
                scale_number(outlet, d).value);
    }
}

TEST_CASE("scale number: the classes part at 1e2 and 1e3", "[scale number]") {
    const auto size_class = [](double d_over_r) {
        return scale_number(d_over_r * 0.5 * si::meters, 1.0 * si::meters).size_class;
    };
    REQUIRE(size_class(99.0) == SizeClass::micro);
    REQUIRE(size_class(100.0) == SizeClass::meso);
    REQUIRE(size_class(1000.0) == SizeClass::meso);
    REQUIRE(size_class(1001.0) == SizeClass::macro);
    REQUIRE_THROWS_AS(size_class(-1.0), InvalidParameter);
}

TEST_CASE(
    "cost: the Rayleigh time of the scaled zirconia grain is 3.9351 us and a fifth of it 0.7870 us",
    "[cost][paper]") {
    // pi 120e-6 sqrt(5600 / 60e6) / (0.1631 * 0.3 + 0.8766)
    const Cost after = cost(scaled(input(), map_of("paper")));
    REQUIRE(after.rayleigh_time.value() == Approx(3.9351e-6).epsilon(2e-5));  // digits printed
    REQUIRE(after.time_step.value() == Approx(7.870e-7).epsilon(1e-4));
    REQUIRE(rayleigh_time(zirconia).value() == Approx(3.9351e-6 / 200.0).epsilon(2e-5));
}

TEST_CASE("cost: the Rayleigh time scales like the contact time of every scheme",
          "[cost][similarity]") {
    for (const std::string& scheme : scheme_names()) {
        const ScaleMap map = ScaleMap::solve(named_scheme(scheme), 200.0);
        INFO(scheme);
        CHECK(rayleigh_time(scaled(zirconia, map)).value() ==
              Approx(map.factor("contact_time") * rayleigh_time(zirconia).value()).epsilon(1e-12));
    }
}

TEST_CASE("cost: coarse graining saves h^3 grains and h steps", "[cost]") {
    const ScaleMap map = map_of("coarse_grain");
    const Cost before = cost(input()), after = cost(scaled(input(), map));
    REQUIRE(originals_per_grain(map) == Approx(8e6).epsilon(1e-12));
    REQUIRE(*after.grains == Approx(1e6).epsilon(1e-12));
    REQUIRE(*after.steps == Approx(12.0 / 7.870e-7).epsilon(1e-4));
    REQUIRE(*before.steps / *after.steps == Approx(200.0).epsilon(1e-6));  // steps are whole
    REQUIRE(after.wall_time->value() == Approx(*after.steps * 1e6 / 1e7).epsilon(1e-12));
}

TEST_CASE("cost: exact scaling saves neither grains nor steps", "[cost]") {
    const Cost before = cost(input()), after = cost(scaled(input(), map_of("exact", 256.0)));
    REQUIRE(*after.grains == *before.grains);
    REQUIRE(*after.steps == Approx(*before.steps).epsilon(1e-9));
}

TEST_CASE("cost: a cone on 80 mm at 53.67 deg holds 3.7e13 grains of zirconia, 187 g",
          "[cost][paper]") {
    // pi 0.08^3 tan(53.67 deg) / 24 = 91.1 cm^3 at 2.05 / 5.6 = 0.366.
    const Heap heap{80e-3 * si::meters, 53.67 * degree, 2.05 / 5.6};
    const double grains = grains_in(heap, zirconia.diameter);
    REQUIRE(grains == Approx(3.7e13).epsilon(0.01));  // two digits
    REQUIRE(grains * grain_mass(zirconia.diameter, zirconia.density).value() ==
            Approx(0.187).epsilon(3e-3));
    REQUIRE(heap_volume({50e-3 * si::meters, 53.87 * degree, 0.5}).value() ==
            Approx(22.4e-6).epsilon(2e-3));
}

TEST_CASE("cost: what is not known is not given", "[cost]") {
    const Cost bare = cost({zirconia, std::nullopt, std::nullopt, 0.2, 1e7});
    REQUIRE_FALSE(bare.grains);
    REQUIRE_FALSE(bare.steps);
    REQUIRE_FALSE(bare.wall_time);
}

TEST_CASE("cost: a value out of range is refused by name", "[cost][domain]") {
    CostInput in = input();
    in.rayleigh_fraction = 1.5;
    REQUIRE_THROWS_WITH(cost(in),
                        Catch::StartsWith("rayleigh_fraction: got 1.5, must lie between 0 and 1"));
    in = input();
    in.duration = -1.0 * si::seconds;
    REQUIRE_THROWS_WITH(cost(in), Catch::StartsWith("duration: got"));
    in = input();
    in.grains = 0.0;
    REQUIRE_THROWS_WITH(cost(in), Catch::StartsWith("grains: got"));
    in = input();
    in.grain_steps_per_second = 0.0;
    REQUIRE_THROWS_WITH(cost(in), Catch::StartsWith("grain_steps_per_second: got"));
    REQUIRE_THROWS_WITH(heap_volume({1.0 * si::meters, 1.6, 0.5}),
                        Catch::StartsWith("heap.angle: got"));
    REQUIRE_THROWS_WITH(heap_volume({0.0 * si::meters, 0.5, 0.5}),
                        Catch::StartsWith("heap.base_diameter: got"));
    REQUIRE_THROWS_WITH(grains_in({1.0 * si::meters, 0.5, 1.0}, zirconia.diameter),
                        Catch::StartsWith("heap.packing_fraction: got"));
}
