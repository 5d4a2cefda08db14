// SPDX-License-Identifier: MIT
// One contact of one grain with a plate: Hertz or JKR, Tsuji's dashpot, Mindlin or rigid Coulomb, rolling resistance.
//
// Without adhesion the normal direction is known in closed form. With y = 4/5 d^(5/4) and ds = d^(1/4) dt Hertz' force with
// Tsuji's dashpot is a damped linear oscillator in s (Antypov & Elliott 2011), so that in the phase f, 0 to pi,
//   d = D (e^(-lf) sin f)^(4/5),   speed = v e^(-lf) (cos f - l sin f),   l = -ln(e)/pi,
//   dt = 4/5 (D/v) (e^(-lf) sin f)^(-1/5) df
// and the rebound is e v by definition. Weight and whatever else pulls take no part in it. In units of D and v every impact of
// one e is the same, and Mindlin's spring sees it through G*/E* and the friction alone.
// With adhesion (d, speed) is integrated until the fold, or until the grain turns back: then it stays.
#pragma once

#include "rigs/one_grain.hpp"

#include <optional>
#include <vector>

namespace rigs {

struct Approach {
    double normal;  // m/s, > 0 towards the plate
    double v, w;    // m/s: the centre along the plate, and R times the spin (= v where it rolls)
};

struct Rebound {
    double normal;    // m/s, away from the plate
    double v, w;      // m/s
    double duration;  // s
    double gap;       // m, at which it parts: 0, or the neck of the adhesive contact
    bool stays;       // it does not come off
};

class OneContact {
  public:
    explicit OneContact(const OneGrain& grain);

    Rebound touch(const Approach&);
    // m, < 0 in compression: height of the lowest point `since` the last touch began.
    double height(double since) const;

  private:
    // What friction sees: nodes of the contact, forces over mass.
    struct Profile {
        std::vector<double> dt;         // [nodes]: from the node before; 0 for the first
        std::vector<double> cap;        // what friction multiplies
        std::vector<double> stiffness;  // of Mindlin's spring
        std::vector<double> shrunk;     // contact radius over that of the node before, at most 1
        std::vector<double> gain;       // force per slip at the end of the step: spring and dashpot
        std::vector<double> yields;     // 1/(1 + 7/2 dt/2 gain): what the step leaves of a slip
        std::vector<double> pulls;      // what a stretch of the spring takes off the slip then
        std::vector<double> reach;      // cap over stiffness; 0 where there is none
        double impulse = 0.0;           // of cap, in all, by the same rule as that of friction

        void resize(std::size_t nodes);
        // Node k, of which `dt` and `cap` are known.
        void set_spring(std::size_t k, double of, double dashpot, double left);
    };

    void drive_apart(const Approach&, Rebound&);  // closed form
    void tear_off(const Approach&, Rebound&);     // with adhesion
    void sample_impact(double e);
    void slide_stiffly(double impulse, Rebound&) const;
    void slide_and_stick(double speed_unit, Rebound&) const;

    const OneGrain& grain_;
    double weight_;                  // m^2/s^2: gravity times the overlap at rest
    std::optional<double> sampled_;  // e of the profile
    Profile profile_;
    double depth_ = 0.0, speed_ = 0.0, loss_ = 0.0, stretch_ = 1.0;  // D, v, l of the last impact
    std::vector<double> times_, overlaps_;                           // of the last adhesive one
};

}  // namespace rigs
