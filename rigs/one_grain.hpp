// SPDX-License-Identifier: MIT
// One grain and one plate in a given world: every number that the single-grain rigs need, taken once from an experiment and a
// World. Raw doubles are SI.
#pragma once

#include "contact/jkr.hpp"
#include "rigs/effects.hpp"
#include "rigs/forward.hpp"

#include <map>
#include <optional>
#include <string>

namespace rigs {

struct OneGrain {
    double radius, mass, inertia;     // m, kg, kg m^2
    double r_star, e_star, g_star;    // m, Pa; E of grain and plate times the numerics' factor
    double gravity;                   // m/s^2, buoyancy taken off; 0 without
    double tilt_angle, tilt_azimuth;  // rad; 0 without
    double work_of_adhesion;          // J/m^2; 0: Hertz
    double rolling_friction;          // 1; 0 without
    bool compliant;                   // Mindlin, else rigid Coulomb
    double stiffness_ratio;           // 1, of Mindlin's spring
    Restitution restitution;
    Friction friction;
    Drag drag;
    Attraction attraction;
    Vibration vibration;
    std::optional<MissingRestitution> missing_restitution;

    contact::Jkr jkr() const { return {e_star, work_of_adhesion}; }
    double pull_off_force() const;  // N, 3/2 pi w R*
    // m, of the contact at rest under a load in N, > 0 pressed; at most the fold's tension.
    double resting_overlap(double load) const;
};

// The numbers that an experiment states, by the keys of World::stated, in SI. Reading units costs more than a whole flight,
// hence once.
class Stated {
  public:
    explicit Stated(const cases::Experiment&);

    // What the world puts in its place, else what is stated, else `otherwise`.
    double value(const World&, const std::string& key, double otherwise) const;
    // Throws scaling::InvalidInput where nothing is stated.
    double value(const World&, const std::string& key) const;
    const std::string& id() const { return id_; }

  private:
    std::string id_;
    std::map<std::string, double> numbers_;
};

enum class Counterpart { plate, grain };

// Throws scaling::InvalidInput where the world lacks a parameter that its physics needs, or the surroundings a fluid.
OneGrain one_grain(const Stated&, const World&, Counterpart = Counterpart::plate);

// The world's parameter. Throws scaling::InvalidInput where there is none.
double parameter(const World&, const std::string& name);
double parameter_or(const World&, const std::string& name, double otherwise);

// Throws scaling::InvalidInput where a missing force depends on anything but one of `variables`.
void check_missing(const World&, const std::string& rig, const std::vector<std::string>& variables);

}  // namespace rigs
