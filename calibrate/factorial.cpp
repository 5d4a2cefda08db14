// SPDX-License-Identifier: MIT
#include "calibrate/designs.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <string_view>

namespace calibrate {
namespace {

using scaling::InvalidParameter;
using scaling::mistake;

constexpr std::string_view letters = "ABCDEFGHJKLMNOPQRSTUVWXYZ";  // I is the identity
constexpr int most_runs = 1 << 20;  // beyond it nobody means a design, and sizes stay ints

// base^exponent, or throws where it exceeds most_runs.
int runs_of(int base, int exponent, const char* design) {
    int runs = 1;
    for (int k = 0; k < exponent; ++k) {
        runs *= base;
        if (runs > most_runs) {
            throw InvalidParameter(mistake(fmt::format("{}.factors", design),
                                           fmt::format("{} at {} levels", exponent, base),
                                           fmt::format("must give at most {} runs", most_runs),
                                           "take a fraction or a Latin hypercube"));
        }
    }
    return runs;
}

void require_factors(int factors, const char* design) {
    if (factors < 1 || factors > static_cast<int>(letters.size())) {
        throw InvalidParameter(mistake(fmt::format("{}.factors", design), std::to_string(factors),
                                       "must be 1 to 25", "the letters A to Z without I"));
    }
}

struct Generator {
    char made;                  // the letter left of "="
    double sign;                // -1 for "E=-AB"
    std::vector<int> multiply;  // columns of the full factorial, 0-based
};

Generator parsed(const std::string& text, int full) {
    const auto refuse = [&](const std::string& rule) -> InvalidParameter {
        return InvalidParameter(mistake("fractional_factorial.generators", '"' + text + '"', rule,
                                        "write a generator as \"D=ABC\" or \"E=-AB\""));
    };
    if (text.size() < 3 || text[1] != '=') throw refuse("must be a letter, =, and letters");
    Generator g{text[0], 1.0, {}};
    std::string_view word = std::string_view(text).substr(2);
    if (word.front() == '-') {
        g.sign = -1.0;
        word.remove_prefix(1);
    }
    if (word.empty()) throw refuse("must be a letter, =, and letters");
    for (const char c : word) {
        const std::size_t column = letters.find(c);
        if (column >= static_cast<std::size_t>(full)) {
            throw refuse(fmt::format("must multiply letters from A to {}", letters[full - 1]));
        }
        g.multiply.push_back(static_cast<int>(column));
    }
    return g;
}

}  // namespace

char factor_letter(int factor) {
    require_factors(factor + 1, "factor_letter");
    return letters[static_cast<std::size_t>(factor)];
}

Eigen::MatrixXd full_factorial(int factors, int levels) {
    require_factors(factors, "full_factorial");
    if (levels < 2) {
        throw InvalidParameter(mistake("full_factorial.levels", std::to_string(levels),
                                       "must be at least 2", "a factor at one level is none"));
    }
    const int runs = runs_of(levels, factors, "full_factorial");
    Eigen::MatrixXd design(runs, factors);
    for (int run = 0; run < runs; ++run) {
        int rest = run;
        for (int factor = 0; factor < factors; ++factor) {
            design(run, factor) = -1.0 + 2.0 * (rest % levels) / (levels - 1);
            rest /= levels;
        }
    }
    return design;
}

Eigen::MatrixXd fractional_factorial(int factors, const std::vector<std::string>& generators) {
    require_factors(factors, "fractional_factorial");
    const int full = factors - static_cast<int>(generators.size());
    if (full < 1) {
        throw InvalidParameter(mistake("fractional_factorial.generators",
                                       std::to_string(generators.size()),
                                       "must be fewer than the factors", "drop a generator"));
    }
    const Eigen::MatrixXd base = full_factorial(full);
    Eigen::MatrixXd design(base.rows(), factors);
    design.leftCols(full) = base;
    for (int k = 0; k < static_cast<int>(generators.size()); ++k) {
        const Generator g = parsed(generators[static_cast<std::size_t>(k)], full);
        if (g.made != factor_letter(full + k)) {
            throw InvalidParameter(
                mistake("fractional_factorial.generators",
                        '"' + generators[static_cast<std::size_t>(k)] + '"',
                        fmt::format("must make factor {}", factor_letter(full + k)),
                        "one generator for each further factor, in order"));
        }
        Eigen::ArrayXd column = Eigen::ArrayXd::Constant(base.rows(), g.sign);
        for (const int c : g.multiply) column *= base.col(c).array();
        design.col(full + k) = column.matrix();
    }
    return design;
}

Eigen::MatrixXd central_composite(int factors, double alpha, int centre_runs) {
    require_factors(factors, "central_composite");
    if (!(alpha > 0.0) || centre_runs < 0) {
        throw InvalidParameter(mistake("central_composite",
                                       fmt::format("alpha {}, {} centre runs", alpha, centre_runs),
                                       "must have alpha > 0 and centre runs >= 0",
                                       "alpha = 2^(factors/4) makes it rotatable"));
    }
    const Eigen::MatrixXd corners = full_factorial(factors);
    Eigen::MatrixXd design =
        Eigen::MatrixXd::Zero(corners.rows() + 2 * factors + centre_runs, factors);
    design.topRows(corners.rows()) = corners;
    for (int factor = 0; factor < factors; ++factor) {
        design(corners.rows() + 2 * factor, factor) = -alpha;
        design(corners.rows() + 2 * factor + 1, factor) = alpha;
    }
    return design;
}

Eigen::MatrixXd fold_over(const Eigen::MatrixXd& design) {
    Eigen::MatrixXd both(2 * design.rows(), design.cols());
    both << design, -design;
    return both;
}

}  // namespace calibrate
