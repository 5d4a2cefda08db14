// SPDX-License-Identifier: MIT
#include "prove/blind_case.hpp"
#include "prove/case_text.hpp"
#include "prove/draft.hpp"
#include "prove/secret.hpp"
#include "prove/stepper.hpp"
#include "prove/user_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace prove {
namespace {

constexpr int attempts = 240;

// One instrument for all experiments: 1 to 8 % of the range of a middling one (geometric mean over the experiments).
void draw_noise(Skeleton& sk, Dice& dice) {
    std::vector<double> logs(channels, 0.0), count(channels, 0.0), share(channels);
    for (const Setup& s : sk.truth) {
        const std::vector<double> y = predict(sk.world, s);
        const std::vector<double> ranges = channel_ranges(
            {s}, Eigen::Map<const Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size())));
        for (const Channel c : s.recorded) {
            const std::size_t k = static_cast<std::size_t>(c);
            double largest = 0.0;
            for (const double value : y)
                if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
            // A channel that hardly changes (a constant restitution) is read to a share of its size.
            logs[k] += std::log(std::max({ranges[k], 0.05 * largest, 1e-15}));
            count[k] += 1.0;
        }
    }
    const double common = dice.log_uniform(0.01, 0.06);
    for (double& s : share) s = common * dice.log_uniform(0.7, 1.4);
    for (std::size_t e = 0; e < sk.truth.size(); ++e) {
        std::vector<double> noise;
        for (const Channel c : sk.truth[e].recorded) {
            const std::size_t k = static_cast<std::size_t>(c);
            noise.push_back(rounded(share[k] * std::exp(logs[k] / count[k]), 3));
        }
        sk.truth[e].noise = sk.stated[e].noise = noise;
    }
}

const Term* term_of(const std::vector<Term>& all, const std::string& effect, Dice& dice) {
    std::vector<const Term*> fitting;
    for (const Term& t : all)
        if (t.effect == effect) fitting.push_back(&t);
    return fitting.empty() ? nullptr : dice.of(fitting);
}

// Skeleton and one effect at the strength asked for.
bool conceal_one(Draft& d, const std::string& effect, double target, Dice& dice) {
    const std::vector<Term> all = terms(d.sk.stated, d.sk.physics);
    const Term* t = term_of(all, effect, dice);
    if (t == nullptr) return false;
    const auto dial = dial_for(*t, d.sk, dice);
    if (!dial) return false;
    const auto strength = solve_strength(d.sk, *dial, target);
    if (!strength) return false;
    d.world = d.sk.world;
    dial->turn(d.world, *strength);
    d.terms = {*t};
    return true;
}

// The mean over the first channel of the recordings with role fit: the headline.
double headline(const Skeleton& sk, const World& w) {
    double sum = 0.0;
    int n = 0;
    for (const Setup& s : sk.truth) {
        if (s.held_out) continue;
        const std::vector<double> y = predict(w, s);
        for (std::size_t k = 0; k < s.at.size(); ++k)
            if (std::isfinite(y[k])) sum += y[k], ++n;
    }
    return sum / n;
}

bool conceal_two(Draft& d, const Plan& plan, Dice& dice) {
    if (!conceal_one(d, plan.effect, plan.target, dice)) return false;
    const World first = d.world;
    const std::vector<Term> all = terms(d.sk.stated, d.sk.physics);
    std::vector<const Term*> others;
    for (const Term& t : all)
        if (t.effect != plan.effect) others.push_back(&t);
    const Term* t = dice.of(others);
    const auto dial = dial_for(*t, d.sk, dice);
    if (!dial) return false;
    if (plan.subkind == "cancelling") {
        const double base = headline(d.sk, d.sk.world);
        const auto excess = [&](double s) {
            World w = first;
            dial->turn(w, s);
            return headline(d.sk, w) - base;
        };
        const double start = headline(d.sk, first) - base;
        double low = 0.0, high = 0.0;
        for (double s = 1e-3; s <= 1.0 && high == 0.0; s *= 1.6) {
            if (excess(s) * start < 0.0)
                high = s;
            else
                low = s;
        }
        if (high == 0.0) return false;
        for (int k = 0; k < 30; ++k) {
            const double s = 0.5 * (low + high);
            (excess(s) * start < 0.0 ? high : low) = s;
        }
        dial->turn(d.world, 0.5 * (low + high));
    } else {
        Skeleton alone = d.sk;
        const auto strength = solve_strength(alone, *dial, plan.target);
        // The noise is the first one's already: only a strength that needs no other is taken.
        if (!strength || alone.stated.front().noise != d.sk.stated.front().noise) return false;
        dial->turn(d.world, *strength);
    }
    d.terms.push_back(*t);
    const std::vector<std::size_t> fits = with_role(d.sk, false);
    d.key.lambda_given_other = {left_by(d.sk, d.world, d.terms[1], fits),
                                left_by(d.sk, d.world, d.terms[0], fits)};
    if (std::min(d.key.lambda_given_other[0], d.key.lambda_given_other[1]) < 25.0) return false;
    return separation(d.sk, d.world, {}, 5.0, fits).d >= 5.0;  // nor is any other one enough
}

bool conceal_outside(Draft& d, const Plan& plan, Dice& dice) {
    // The skeleton is one in which a named effect could hide, as in every other kind.
    const std::vector<Outside> kinds = outside_kinds(plan.rig);
    const Outside kind = dice.of(kinds);
    const auto dial = outside_dial(kind, d.sk, dice);
    if (!dial) return false;
    const auto strength = solve_strength(d.sk, *dial, plan.target);
    if (!strength) return false;
    d.world = d.sk.world;
    dial->turn(d.world, *strength);
    const Mismatch m = mismatch(d.sk, d.world);
    if (m.lambda < 25.0) return false;
    if (separation(d.sk, d.world, {}, 5.0, with_role(d.sk, false)).d < 5.0) return false;
    d.key.outside = to_string(kind);
    return true;
}

bool attempt(Draft& d, const Plan& plan, std::uint64_t seed, int number, int k) {
    Dice dice(seed, static_cast<std::uint64_t>(number), 100 + static_cast<std::uint64_t>(k));
    d = Draft{};
    d.sk = draw(plan.rig, dice);
    if (plan.kind == Kind::null) {
        d.sk.noise = {};
        d.sk.noise.heavy = plan.subkind == "heavy";
        if (plan.subkind == "correlated")
            d.sk.noise.correlation = rounded(dice.uniform(0.3, 0.9), 2);
    }
    draw_noise(d.sk, dice);
    switch (plan.kind) {
        case Kind::pair:
            return conceal_two(d, plan, dice);
        case Kind::outside:
            return conceal_outside(d, plan, dice);
        case Kind::numerical: {
            const auto run = draw_user_run(d.sk, plan.target, dice);
            if (!run) return false;
            d.run = *run;
            d.world = d.sk.world;
            return true;
        }
        default:
            break;
    }
    if (!conceal_one(d, plan.effect, plan.target, dice)) return false;
    if (plan.kind == Kind::look_alike) {
        if (mismatch(d.sk, d.world).lambda < 25.0) return false;
        return separation(d.sk, d.world, {plan.effect}, 3.0).d < 3.0;
    }
    if (plan.kind == Kind::null) {
        // An effect could have been hidden here; it was not.
        d.world = d.sk.world;
        d.terms.clear();
    }
    return true;
}

// Mis-set on purpose: every free start at the far end of its range.
void mis_set(Skeleton& sk) {
    for (Stated& p : sk.parameters)
        if (p.free)
            p.start =
                rounded(p.truth - p.low > p.high - p.truth ? p.low + 0.1 * (p.truth - p.low)
                                                           : p.high - 0.1 * (p.high - p.truth),
                        3);
}

Eigen::VectorXd noisy(const Skeleton& sk, const Eigen::VectorXd& truth, Dice& dice) {
    Eigen::VectorXd y = truth;
    const double rho = sk.noise.correlation, rest = std::sqrt(1.0 - rho * rho);
    Eigen::Index k = 0;
    for (const Setup& s : sk.truth) {
        for (const double deviation : s.noise) {
            double before = 0.0;
            for (std::size_t row = 0; row < s.at.size(); ++row, ++k) {
                const double draw = sk.noise.heavy ? dice.student4() : dice.normal();
                before = row == 0 ? draw : rho * before + rest * draw;
                y[k] += deviation * before;
            }
        }
    }
    return y;
}

}  // namespace

std::string case_name(int number) { return fmt::format("case-{:04d}", number); }

BlindCase make_case(std::uint64_t seed, int number, Figures figures) {
    const Plan first = plan(seed, number);
    Plan p = first;
    Draft d;
    // Attempts are cheap where no separation is needed.
    const int patience = first.kind == Kind::single || first.kind == Kind::null ? 40 : 12;
    for (int k = 0; k < attempts && !d.found; ++k) {
        // Some effects cannot be hidden at that strength in an unlucky rig: another then.
        if (k > 0 && k % patience == 0) p = another(first, seed, number, k / patience);
        try {
            d.found = attempt(d, p, seed, number, k);
        } catch (const std::runtime_error&) {
            d.found = false;  // a fit went where the motion has no answer
        }
    }
    if (!d.found)
        throw std::runtime_error(
            fmt::format("no case of kind {} after {} attempts, seed {}, number {}",
                        to_string(p.kind), attempts, seed, number));
    if (p.subkind == "mis_set") mis_set(d.sk);
    Dice dice(seed, static_cast<std::uint64_t>(number), 1);
    name(d, p, number);
    if (figures == Figures::all) tell(d, p);
    const Eigen::VectorXd truth = predict(d.world, d.sk.truth);
    if ((truth.array() == far_off).any()) throw NoStep();
    const Eigen::VectorXd recordings = noisy(d.sk, truth, dice);
    if (figures == Figures::all) tell_held_out(d, recordings);
    BlindCase made;
    made.number = number;
    Eigen::VectorXd simulated;
    std::string numerics;
    if (p.kind == Kind::numerical) {
        numerics = numerics_text(d.run);
        if (d.run.hands_over) simulated = start_run(d.sk, d.run);
    } else if (d.sk.states_numerics) {
        numerics = numerics_text(harmless_run(d.sk));
        if (d.sk.hands_over_run) simulated = start_run(d.sk, {});
    }
    made.files = case_files(d.sk, d.key.name, numerics, recordings, simulated);
    made.key = d.key;
    made.key_text = key_text(d.key);
    made.skeleton = std::move(d.sk);
    made.world = d.world;
    made.recordings = recordings;
    return made;
}

void write(const BlindCase& made, const std::string& folder, const std::string& keys) {
    namespace fs = std::filesystem;
    const fs::path home = fs::path(folder) / made.key.name;
    fs::create_directories(home);
    fs::create_directories(keys);
    const auto save = [](const fs::path& path, const std::string& text) {
        std::ofstream out(path, std::ios::binary);
        out << text;
        if (!out.flush()) throw std::runtime_error("cannot write " + path.string());
    };
    for (const auto& [name, text] : made.files) save(home / name, text);
    save(fs::path(keys) / (made.key.name + ".json"), made.key_text);
}

}  // namespace prove
