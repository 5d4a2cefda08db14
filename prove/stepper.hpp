// SPDX-License-Identifier: MIT
// GSL's Dormand-Prince 8(9) stepper with its error control, one step at a time, so that events can be looked for in between.
#pragma once

#include <gsl/gsl_odeiv2.h>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <vector>

namespace prove {

// Rates are no numbers: parameters far from any world.
struct NoStep : std::runtime_error {
    NoStep() : std::runtime_error("the integrator found no step: rates that are no numbers") {}
};

class Stepper {
  public:
    using Rates = std::function<void(double t, const double* y, double* rate)>;

    // `absolute` is the tolerance of each unknown, [unknowns]; `relative` of its size.
    Stepper(Rates, std::vector<double> absolute, double relative);
    ~Stepper();
    Stepper(const Stepper&) = delete;
    Stepper& operator=(const Stepper&) = delete;

    // One step from t to at most `until`; `h` is the step to try and then the next one. Throws std::runtime_error where the
    // rates are no numbers.
    void advance(double& t, double until, double& h, double* y);
    void restart();  // after a jump of the state or of the rates
    void rates(double t, const double* y, double* rate) const { rates_(t, y, rate); }

  private:
    static int evaluate(double t, const double* y, double* rate, void* self);
    Rates rates_;
    gsl_odeiv2_system system_;
    gsl_odeiv2_step* step_;
    gsl_odeiv2_control* control_;
    gsl_odeiv2_evolve* evolve_;
};

// Root of f between a and b, where it changes its sign, to about 1e-14 of the interval (Brent).
double root(const std::function<double(double)>& f, double a, double b);

}  // namespace prove
