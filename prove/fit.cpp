// SPDX-License-Identifier: MIT
#include "prove/fit.hpp"

#include "prove/stepper.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace prove {
namespace {

double& place(const Unknown& u, World& w, std::vector<Setup>& setups, std::size_t experiment) {
    if (u.in_world != nullptr) return w.*u.in_world;
    if (u.in_setup != nullptr) return setups[experiment].*u.in_setup;
    if (!u.scaled.empty()) return w.scale[static_cast<std::size_t>(u.scaled.front())];
    return w.offset[static_cast<std::size_t>(u.shifted.front())];
}

void put_one(const Unknown& u, double value, World& w, std::vector<Setup>& setups) {
    if (u.in_world != nullptr) {
        w.*u.in_world = value;
    } else if (u.in_setup != nullptr) {
        if (u.experiment >= 0) {
            setups[static_cast<std::size_t>(u.experiment)].*u.in_setup = value;
        } else {
            for (Setup& s : setups) s.*u.in_setup = value;
        }
    }
    for (const Channel c : u.scaled) w.scale[static_cast<std::size_t>(c)] = value;
    for (const Channel c : u.shifted) w.offset[static_cast<std::size_t>(c)] = value;
}

// Inner coordinate: 0 to 1 over the range, in the logarithm where that is asked for.
double inner(const Unknown& u, double value) {
    if (!u.logarithmic) return (value - u.low) / (u.high - u.low);
    return std::log(std::max(value, u.low) / u.low) / std::log(u.high / u.low);
}
double outer(const Unknown& u, double x) {
    if (!u.logarithmic) return u.low + x * (u.high - u.low);
    return u.low * std::pow(u.high / u.low, x);
}
double stretch(const Unknown& u, double x) {  // d value/d inner
    return u.logarithmic ? outer(u, x) * std::log(u.high / u.low) : u.high - u.low;
}

std::size_t rows_of(const std::vector<Setup>& setups) {
    std::size_t n = 0;
    for (const Setup& s : setups) n += s.size();
    return n;
}

Eigen::Index at(std::size_t k) { return static_cast<Eigen::Index>(k); }

class Problem {
  public:
    Problem(World w, std::vector<Setup> setups, const std::vector<Unknown>& unknowns,
            const Noise& noise, const Eigen::VectorXd& wanted)
        : world(std::move(w)),
          setups_(std::move(setups)),
          unknowns_(unknowns),
          noise_(noise),
          wanted_(wanted) {}

    // Whitened misfit, then a row for each prior.
    Eigen::VectorXd misfit(const Eigen::VectorXd& x) {
        World w = world;
        std::vector<Setup> s = setups_;
        for (std::size_t k = 0; k < unknowns_.size(); ++k)
            put_one(unknowns_[k], outer(unknowns_[k], x[at(k)]), w, s);
        last_ = predict(w, s);
        return rows(s, last_, x);
    }

    Eigen::MatrixXd jacobian(const Eigen::VectorXd& x, const Eigen::VectorXd& here) {
        Eigen::MatrixXd j(here.size(), x.size());
        const Eigen::VectorXd base = last_;
        for (std::size_t k = 0; k < unknowns_.size(); ++k) {
            const Unknown& u = unknowns_[k];
            double step = u.deviation > 0.0 ? 1e-3 * u.deviation / (u.high - u.low) : 2e-5;
            if (x[at(k)] + step > 1.0) step = -step;
            Eigen::VectorXd moved = x;
            moved[at(k)] += step;
            World w = world;
            std::vector<Setup> s = setups_;
            for (std::size_t i = 0; i < unknowns_.size(); ++i)
                put_one(unknowns_[i], outer(unknowns_[i], moved[at(i)]), w, s);
            Eigen::VectorXd there = base;
            Eigen::Index first = 0;
            for (std::size_t e = 0; e < s.size(); ++e) {
                const Eigen::Index n = at(s[e].size());
                if (u.in_setup == nullptr || u.experiment < 0 ||
                    u.experiment == static_cast<int>(e)) {
                    try {
                        const std::vector<double> y = predict_one(w, s[e]);
                        there.segment(first, n) = Eigen::Map<const Eigen::VectorXd>(y.data(), n);
                    } catch (const NoStep&) {
                        // no slope that way
                    }
                }
                first += n;
            }
            j.col(at(k)) = (rows(s, there, moved) - here) / step;
        }
        return j;
    }

    World world;

  private:
    static std::vector<double> predict_one(const World& w, const Setup& s) {
        return prove::predict(w, s);
    }
    Eigen::VectorXd rows(const std::vector<Setup>& s, const Eigen::VectorXd& predicted,
                         const Eigen::VectorXd& x) const {
        const Eigen::VectorXd data = whitened(s, noise_, predicted - wanted_);
        Eigen::VectorXd all(data.size() + x.size());
        all.head(data.size()) = data;
        for (std::size_t k = 0; k < unknowns_.size(); ++k) {
            const Unknown& u = unknowns_[k];
            all[data.size() + at(k)] =
                u.deviation > 0.0 ? (outer(u, x[at(k)]) - u.mean) / u.deviation : 0.0;
        }
        return all;
    }
    std::vector<Setup> setups_;
    const std::vector<Unknown>& unknowns_;
    const Noise& noise_;
    const Eigen::VectorXd& wanted_;
    Eigen::VectorXd last_{};
};

// The step of Marquardt with what lies at an end and would go beyond it held there.
Eigen::VectorXd marquardt(const Eigen::MatrixXd& normal, const Eigen::VectorXd& gradient,
                          const Eigen::VectorXd& x, double lambda) {
    Eigen::MatrixXd a = normal;
    Eigen::VectorXd g = gradient;
    const double floor = 1e-12 * std::max(1e-30, normal.diagonal().maxCoeff());
    for (Eigen::Index k = 0; k < x.size(); ++k) {
        const bool held = (x[k] <= 0.0 && g[k] > 0.0) || (x[k] >= 1.0 && g[k] < 0.0);
        if (held) {
            a.row(k).setZero();
            a.col(k).setZero();
            a(k, k) = 1.0;
            g[k] = 0.0;
        } else {
            a(k, k) += lambda * a(k, k) + floor;
        }
    }
    return -a.ldlt().solve(g);
}

}  // namespace

void put(const std::vector<Unknown>& unknowns, const Eigen::VectorXd& theta, World& w,
         std::vector<Setup>& setups) {
    for (std::size_t k = 0; k < unknowns.size(); ++k) put_one(unknowns[k], theta[at(k)], w, setups);
}

double value_of(const Unknown& u, const World& w, const std::vector<Setup>& setups) {
    World copy = w;
    std::vector<Setup> others = setups;
    return place(u, copy, others, static_cast<std::size_t>(std::max(u.experiment, 0)));
}

Eigen::VectorXd predict(const World& w, const std::vector<Setup>& setups) {
    Eigen::VectorXd all(at(rows_of(setups)));
    Eigen::Index first = 0;
    for (const Setup& s : setups) {
        try {
            const std::vector<double> y = prove::predict(w, s);
            for (const double value : y) all[first++] = value;
        } catch (const NoStep&) {
            for (std::size_t k = 0; k < s.size(); ++k) all[first++] = far_off;
        }
    }
    return all;
}

Eigen::VectorXd whitened(const std::vector<Setup>& setups, const Noise& noise,
                         const Eigen::VectorXd& residual) {
    Eigen::VectorXd out(residual.size());
    const double rho = noise.correlation, rest = std::sqrt(1.0 - rho * rho);
    Eigen::Index k = 0;
    for (const Setup& s : setups) {
        for (std::size_t c = 0; c < s.recorded.size(); ++c) {
            double before = 0.0;
            for (std::size_t row = 0; row < s.at.size(); ++row, ++k) {
                const double r = std::isfinite(residual[k]) ? residual[k] / s.noise[c] : 0.0;
                out[k] = row == 0 ? r : (r - rho * before) / rest;
                before = r;
            }
        }
    }
    return out;
}

Fit fit(World world, std::vector<Setup> setups, const std::vector<Unknown>& unknowns,
        const Noise& noise, const Eigen::VectorXd& wanted, int iterations, double tolerance) {
    Problem p(world, setups, unknowns, noise, wanted);
    Eigen::VectorXd x(at(unknowns.size()));
    for (std::size_t k = 0; k < unknowns.size(); ++k)
        x[at(k)] = std::clamp(inner(unknowns[k], value_of(unknowns[k], world, setups)), 0.0, 1.0);
    Eigen::VectorXd here = p.misfit(x);
    double cost = here.squaredNorm(), lambda = 1e-2;
    Eigen::MatrixXd j;
    int small = 0;  // gains in a row
    for (int k = 0; k < iterations && x.size() > 0; ++k) {
        here = p.misfit(x);
        j = p.jacobian(x, here);
        const Eigen::MatrixXd normal = j.transpose() * j;
        const Eigen::VectorXd gradient = j.transpose() * here;
        bool better = false;
        double gain = 0.0;
        for (int tries = 0; tries < 12 && !better; ++tries) {
            const Eigen::VectorXd next =
                (x + marquardt(normal, gradient, x, lambda)).cwiseMax(0.0).cwiseMin(1.0);
            const double there = p.misfit(next).squaredNorm();
            if (there < cost) {
                better = true;
                gain = cost - there;
                cost = there;
                x = next;
                lambda = std::max(1e-7, 0.1 * lambda);
            } else {
                lambda *= 8.0;
            }
        }
        small = gain < tolerance * cost + 1e-4 ? small + 1 : 0;
        if (!better || small == 2 || gain < 1e-6) break;
    }
    here = p.misfit(x);
    Fit f{world, setups, Eigen::VectorXd(x.size()),      0.0,
          0.0,   here,   Eigen::MatrixXd(here.size(), 0)};
    for (std::size_t k = 0; k < unknowns.size(); ++k) f.theta[at(k)] = outer(unknowns[k], x[at(k)]);
    put(unknowns, f.theta, f.world, f.setups);
    f.penalty = here.tail(x.size()).squaredNorm();
    f.chi2 = here.squaredNorm() - f.penalty;
    if (x.size() > 0) {
        j = p.jacobian(x, here);
        for (std::size_t k = 0; k < unknowns.size(); ++k)
            j.col(at(k)) /= stretch(unknowns[k], x[at(k)]);
        f.slopes = std::move(j);
    }
    return f;
}

Eigen::VectorXd standard_errors(const Fit& f) {
    const Eigen::Index n = f.theta.size();
    Eigen::VectorXd errors = Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity());
    if (n == 0) return errors;
    // Scaled to a unit diagonal first: the unknowns have different units.
    const Eigen::MatrixXd information = f.information();
    Eigen::VectorXd d = information.diagonal().cwiseMax(0.0).cwiseSqrt();
    for (Eigen::Index k = 0; k < n; ++k)
        if (!(d[k] > 0.0)) d[k] = 1e-300;
    Eigen::MatrixXd scaled = information;
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index k = 0; k < n; ++k) scaled(i, k) /= d[i] * d[k];
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);
    for (Eigen::Index k = 0; k < n; ++k) {
        double variance = 0.0;
        for (Eigen::Index i = 0; i < n; ++i) {
            const double v = solver.eigenvectors()(k, i);
            variance += v * v / std::max(solver.eigenvalues()[i], 1e-14);
        }
        errors[k] =
            d[k] > 1e-200 ? std::sqrt(variance) / d[k] : std::numeric_limits<double>::infinity();
    }
    return errors;
}

}  // namespace prove
