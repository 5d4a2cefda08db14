// SPDX-License-Identifier: MIT
#include "statistics/hyperparameters.hpp"

#include "scaling/errors.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multimin.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>

namespace statistics {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// The posterior of the logarithms that are open, for y in units of its spread.
struct Posterior {
    Data data;
    Kernel kernel;
    HyperparameterPrior prior;
    double unit;  // spread of y

    Index factors() const { return data.x.cols(); }

    Hyperparameters from(const VectorXd& logs) const {
        const Index d = factors();
        const double noise =
            prior.known_noise ? std::max(*prior.known_noise / unit, 1e-6) : std::exp(logs[d + 2]);
        return {logs.head(d).array().exp(), std::exp(logs[d]),
                prior.plane ? std::exp(logs[d + 1]) : 0.0, noise};
    }

    bool open(Index k) const {
        return !(k == factors() + 1 && !prior.plane) &&
               !(k == factors() + 2 && prior.known_noise.has_value());
    }

    LogNormal of(Index k) const {
        const Index d = factors();
        return k < d        ? prior.inverse_length
               : k == d     ? prior.amplitude
               : k == d + 1 ? prior.slope
                            : prior.noise;
    }

    VectorXd medians() const {
        VectorXd m(factors() + 3);
        for (Index k = 0; k < m.size(); ++k) m[k] = std::log(of(k).median);
        return m;
    }

    double value(const VectorXd& logs, VectorXd* gradient = nullptr) const {
        const double never = -std::numeric_limits<double>::infinity();
        if (logs.cwiseAbs().maxCoeff() > 25.0) return never;  // exp(25) = 7e10 spreads
        try {
            const GaussianProcess g(data, kernel, from(logs));
            double sum = g.log_likelihood();
            if (gradient) *gradient = g.gradient();
            for (Index k = 0; k < logs.size(); ++k) {
                const LogNormal p = of(k);
                const double away = (logs[k] - std::log(p.median)) / p.spread;
                if (gradient) (*gradient)[k] = open(k) ? (*gradient)[k] - away / p.spread : 0.0;
                if (open(k)) sum -= 0.5 * away * away;
            }
            return sum;
        } catch (const scaling::InvalidParameter&) {
            return never;  // a covariance that cannot be factored
        }
    }
};

Posterior posterior_of(const Data& data, Kernel kernel, const HyperparameterPrior& prior) {
    if (data.y.size() < 2)
        throw scaling::InvalidParameter(scaling::mistake("hyperparameters.data",
                                                         std::to_string(data.y.size()) + " runs",
                                                         "must be at least 2", "add runs"));
    const double mean = data.y.mean();
    const double spread =
        std::sqrt((data.y.array() - mean).square().sum() / static_cast<double>(data.y.size() - 1));
    // Runs that are all equal have no spread; any unit will do.
    const double unit = spread > 0.0 ? spread : std::max(1e-9 * std::abs(mean), 1e-300);
    return {{data.x, (data.y.array() - mean) / unit, data.noise_factor}, kernel, prior, unit};
}

Hyperparameters in_unit(Hyperparameters t, double unit) {
    t.amplitude *= unit, t.slope *= unit, t.noise *= unit;
    return t;
}

VectorXd vector_of(const gsl_vector* v) {
    VectorXd x(static_cast<Index>(v->size));
    for (Index k = 0; k < x.size(); ++k) x[k] = gsl_vector_get(v, static_cast<std::size_t>(k));
    return x;
}

void descend(const gsl_vector* at, void* p, double* f, gsl_vector* g) {
    VectorXd gradient = VectorXd::Zero(static_cast<Index>(at->size));
    const double value = static_cast<Posterior*>(p)->value(vector_of(at), &gradient);
    *f = std::isfinite(value) ? -value : 1e10;  // a wall that the line search turns back from
    for (Index k = 0; k < gradient.size(); ++k)
        gsl_vector_set(g, static_cast<std::size_t>(k), -gradient[k]);
}

VectorXd climbed(Posterior& p, const VectorXd& start) {
    constexpr int iterations = 60;
    const auto n = static_cast<std::size_t>(start.size());
    gsl_multimin_function_fdf f;
    f.n = n, f.params = &p;
    f.fdf = descend;
    f.f = [](const gsl_vector* at, void* q) {
        const double value = static_cast<Posterior*>(q)->value(vector_of(at));
        return std::isfinite(value) ? -value : 1e10;
    };
    f.df = [](const gsl_vector* at, void* q, gsl_vector* g) {
        double unused = 0.0;
        descend(at, q, &unused, g);
    };
    const std::unique_ptr<gsl_vector, void (*)(gsl_vector*)> x(gsl_vector_alloc(n),
                                                               gsl_vector_free);
    for (std::size_t k = 0; k < n; ++k) gsl_vector_set(x.get(), k, start[static_cast<Index>(k)]);
    const std::unique_ptr<gsl_multimin_fdfminimizer, void (*)(gsl_multimin_fdfminimizer*)> s(
        gsl_multimin_fdfminimizer_alloc(gsl_multimin_fdfminimizer_vector_bfgs2, n),
        gsl_multimin_fdfminimizer_free);
    gsl_multimin_fdfminimizer_set(s.get(), &f, x.get(), 0.1, 0.1);
    for (int k = 0; k < iterations; ++k) {
        if (gsl_multimin_fdfminimizer_iterate(s.get()) != GSL_SUCCESS) break;
        if (gsl_multimin_test_gradient(s->gradient, 1e-4) == GSL_SUCCESS) break;
    }
    return vector_of(s->x);
}

VectorXd summit(Posterior& p) {
    VectorXd best = p.medians();
    double highest = p.value(best);
    for (const double shift : {-1.0, 0.0, 1.0}) {
        VectorXd start = p.medians();
        start.head(p.factors()).array() += shift;
        const VectorXd end = climbed(p, start);
        const double value = p.value(end);
        if (value > highest) highest = value, best = end;
    }
    return best;
}

// One coordinate: a level below the density, an interval stepped out to it, shrunk until a point
// lies above it.
void slice(const Posterior& p, VectorXd& at, double& value, Index k, std::mt19937_64& random) {
    constexpr double width = 1.0;  // of a first interval, in the logarithm
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-53; };
    const double level = value + std::log(1.0 - uniform());
    VectorXd trial = at;
    const auto there = [&](double x) { return trial[k] = x, p.value(trial); };
    double low = at[k] - width * uniform(), high = low + width;
    while (there(low) > level) low -= width;
    while (there(high) > level) high += width;
    for (;;) {
        const double x = low + (high - low) * uniform(), found = there(x);
        if (found > level) {
            at[k] = x, value = found;
            return;
        }
        (x < at[k] ? low : high) = x;
    }
}

}  // namespace

Hyperparameters most_probable(const Data& data, Kernel kernel, const HyperparameterPrior& prior) {
    Posterior p = posterior_of(data, kernel, prior);
    return in_unit(p.from(summit(p)), p.unit);
}

std::vector<Hyperparameters> drawn(const Data& data, Kernel kernel,
                                   const HyperparameterPrior& prior, int count,
                                   std::uint64_t seed) {
    constexpr int forgotten = 20, apart = 5;  // sweeps over all coordinates
    Posterior p = posterior_of(data, kernel, prior);
    VectorXd at = summit(p);
    double value = p.value(at);
    std::mt19937_64 random(seed);
    std::vector<Hyperparameters> list;
    for (int sweep = 1; static_cast<int>(list.size()) < count; ++sweep) {
        for (Index k = 0; k < at.size(); ++k)
            if (p.open(k)) slice(p, at, value, k, random);
        if (sweep > forgotten && (sweep - forgotten) % apart == 0)
            list.push_back(in_unit(p.from(at), p.unit));
    }
    return list;
}

}  // namespace statistics
