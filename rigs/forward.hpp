// SPDX-License-Identifier: MIT
// A forward model: what an experiment would have recorded in a given world. It is all that a fit or a judge knows of a rig, so
// that a single grain, a heap or another engine can answer alike. Laws of the single-grain rigs: docs/effects.md. All in SI.
#pragma once

#include "cases/case.hpp"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rigs {

// A force that no law explains, as a function of one variable of the state: straight between the knots, constant beyond them.
struct MissingForce {
    std::string variable;         // one of ForwardModel::variables
    std::vector<double> knots;    // SI, rising
    std::vector<double> newtons;  // drop: up; incline: downhill; pull_off: repulsive
};

// A share by which the normal speed after an impact is off, that no law explains, as a function of one variable of the impact.
struct MissingRestitution {
    std::string
        variable;  // "impact_speed", m/s, normal; "impact_angle", rad, of the way in from the normal
    std::vector<double> knots;  // SI, rising
    std::vector<double>
        shares;  // 0: as the model says; straight between the knots, constant beyond them
};

// What acts, and how strongly.
struct World {
    std::set<std::string> physics;  // names of docs/effects.md
    std::map<std::string, double>
        parameters;  // left out: restitution 1, friction 0, contact angle 0, stiffness ratio 1
    // In place of what the case states: "grain.diameter", "grain.density", "grain.youngs_modulus", "grain.poisson_ratio",
    // "conditions.height", ...
    std::map<std::string, double> stated;
    std::optional<cases::Numerics>
        numerics;  // as the user's run was made; without: as exact as need be
    std::optional<MissingForce> missing;
    std::optional<MissingRestitution> missing_restitution{};  // drop, impact: without numerics
};

// Where the channels are asked for.
struct Ordinates {
    std::vector<double>
        at;  // drop, incline: t; impact: angle; pull_off: separation, or displacement where the drive is known
    std::vector<bool> retract;  // pull_off: the branch of each; else empty
};

using Curves =
    std::map<std::string, std::vector<double>>;  // [ordinates]; NaN where the rig has no answer

class ForwardModel {
  public:
    virtual ~ForwardModel() = default;

    // Channels that it answers: drop z, x; incline s, spin; impact rebound_angle, normal_restitution, tangential_restitution,
    // rebound_spin; pull_off force. Measurement effects and noise are not in it. Ordinates may come in any order.
    // Smooth in every parameter to about 1e-7 of the channel's range, but where the physics jumps. May be called by several
    // threads at once. Throws scaling::InvalidInput where the world lacks a parameter that its physics needs.
    virtual Curves predict(const World&, const Ordinates&) const = 0;

    // What the state was there: drop "t", "z", "speed", "impact_speed" (of the bounce before, else 0); incline "t", "s", "speed",
    // "spin", "slip"; impact "angle", "normal_speed"; pull_off "separation".
    virtual Curves variables(const World&, const Ordinates&) const = 0;

    // Effects of docs/effects.md that can act here, the measurement effects left out.
    virtual std::set<std::string> effects() const = 0;
};

// Of an experiment of the rigs drop, incline, impact and pull_off. Throws scaling::InvalidInput for another rig.
std::unique_ptr<ForwardModel> forward_model(const cases::Experiment&);

// Where the recording has its rows. Throws scaling::InvalidInput where there is none.
Ordinates recorded_ordinates(const cases::Experiment&);

// Where the user's own run has them. Throws scaling::InvalidInput where there is none.
Ordinates simulated_ordinates(const cases::Experiment&);

// Where the recording has its rows, else the user's own run; where there is neither, a range that shows the rig: two seconds,
// 2 to 88 degrees, twice the overlap under the preload outwards and once inwards.
Ordinates ordinates_of(const cases::Experiment&);

// The channel that the ordinates are: "t", "angle", "separation" or "displacement".
std::string ordinate_name(const cases::Experiment&);

// What the user simulates: physics, parameter values and numerics of the model, with `drag_coefficient` turned into the
// `drag_factor` that makes it the curve's value at the fastest speed which the experiments reach at their simulated, else
// recorded, times.
World world_of(const cases::Case&, const cases::Experiment&);

// `drag_coefficient` is told at the fastest recorded speed, the law wants a factor on the curve: their quotient, Cd(Re) of
// docs/effects.md. `speed` in m/s, > 0.
double drag_curve(const cases::Experiment&, double speed);

}  // namespace rigs
