// SPDX-License-Identifier: MIT
// Properties that hold for every scale map, tried on random ones.
#include "scaling/adhesion.hpp"

#include <catch2/catch.hpp>

#include <random>
#include <string>
#include <vector>

using namespace scaling;

namespace {

// Maps drawn from one seeded stream, so that a failure can be repeated.
class RandomMaps {
  public:
    // Any density and time exponents, so any undistorted map; the time through a half.
    Scheme scheme() {
        return own_scheme({"density=" + std::to_string(whole(-3, 3)),
                           "time=" + std::to_string(whole(-6, 6)) + "/2"},
                          false);
    }
    double h() { return whole(1, 4000) / 8.0; }

  private:
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
    std::mt19937 engine_{20261016};
};

constexpr int draws = 100;

Approx same(double value) { return Approx(value).epsilon(1e-12); }  // algebra

}  // namespace

TEST_CASE("scale maps are a group: scaling by h1 and then by h2 is scaling by h1 h2",
          "[group law]") {
    RandomMaps random;
    for (int k = 0; k < draws; ++k) {
        const Scheme scheme = random.scheme();
        const double h1 = random.h(), h2 = random.h();
        const ScaleMap first = ScaleMap::solve(scheme, h1), second = ScaleMap::solve(scheme, h2);
        const ScaleMap both = ScaleMap::solve(scheme, h1 * h2),
                       back = ScaleMap::solve(scheme, 1.0 / h1);
        for (const NamedQuantity& q : quantity_table()) {
            INFO(q.name << ", h " << h1 << " and " << h2);
            CHECK(first.factor(q.name) * second.factor(q.name) == same(both.factor(q.name)));
            CHECK(first.factor(q.name) * back.factor(q.name) == same(1.0));
        }
    }
}

TEST_CASE("an undistorted map keeps every dimensionless group", "[group law]") {
    const std::vector<Variable> variables = {{"density", "density", 1.0},
                                             {"gravity", "gravity", 1.0},
                                             {"grain_diameter", "length", 1.0},
                                             {"apparatus_length", "apparatus_length", 1.0},
                                             {"youngs_modulus", "youngs_modulus", 1.0},
                                             {"work_of_adhesion", "work_of_adhesion", 1.0},
                                             {"velocity", "velocity", 1.0},
                                             {"equilibrium_separation", "length", 1.0},
                                             {"fluid_density", "density", 1.0},
                                             {"fluid_viscosity", "viscosity", 1.0},
                                             {"surface_tension", "surface_tension", 1.0},
                                             {"liquid_volume", "liquid_volume", 1.0},
                                             {"spin", "spin", 1.0},
                                             {"number_rate", "number_rate", 1.0},
                                             {"hamaker_constant", "hamaker_constant", 1.0}};
    const std::vector<PiGroup> groups = groups_of(variables, named_groups(0.3));
    RandomMaps random;
    for (int k = 0; k < draws; ++k) {
        const ScaleMap map = ScaleMap::solve(random.scheme(), random.h());
        for (const PiGroup& g : groups) {
            INFO(g.name);
            CHECK(change_of(g, variables, map) == Exponents{});
        }
    }
}

TEST_CASE(
    "an undistorted map leaves adhesion no choice: every invariant asks for the map's own factor",
    "[group law]") {
    RandomMaps random;
    for (int k = 0; k < draws; ++k) {
        const ScaleMap map = ScaleMap::solve(random.scheme(), random.h());
        for (const Invariant invariant : all_invariants()) {
            INFO(to_string(invariant));
            CHECK(adhesion_exponents(map, invariant) == map.exponents("work_of_adhesion"));
        }
    }
}
