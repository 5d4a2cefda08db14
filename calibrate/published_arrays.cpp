// SPDX-License-Identifier: MIT
#include "calibrate/designs.hpp"
#include "scaling/errors.hpp"

#include <array>
#include <string_view>

namespace calibrate {
namespace {

// First rows as printed by Plackett & Burman (1946), pages 323 and 324.
constexpr std::array<std::string_view, 6> first_rows{"+++-+--",
                                                     "++-+++---+-",
                                                     "++++-+-++--+---",
                                                     "++--++++-+-+----++-",
                                                     "+++++-+-++--++--+-+----",
                                                     "-+-+++---+++++-+++--+----+-+-++--+-"};

// L18 as Taguchi prints it, levels 1 to 3 of the columns 1 to 8.
constexpr std::array<std::string_view, 18> l18_rows{
    "11111111", "11222222", "11333333", "12112233", "12223311", "12331122",
    "13121323", "13232131", "13313212", "21133221", "21211332", "21322113",
    "22123132", "22231213", "22312321", "23132312", "23213123", "23321231"};

// A column of a 3^k array is a sum modulo 3 of the base columns: weights of a, b, c.
using Weights = std::array<int, 3>;
constexpr std::array<Weights, 4> l9_columns{{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}};
constexpr std::array<Weights, 13> l27_columns{{{1, 0, 0},
                                               {0, 1, 0},
                                               {1, 1, 0},
                                               {2, 1, 0},
                                               {0, 0, 1},
                                               {1, 0, 1},
                                               {2, 0, 1},
                                               {0, 1, 1},
                                               {1, 1, 1},
                                               {2, 1, 1},
                                               {0, 2, 1},
                                               {1, 2, 1},
                                               {2, 2, 1}}};

// Shape [3^base][columns]; the last base column changes fastest, as Taguchi prints.
template <std::size_t columns>
Eigen::MatrixXd sums_modulo_3(const std::array<Weights, columns>& weights, int base) {
    const int runs = base == 2 ? 9 : 27;
    Eigen::MatrixXd design(runs, static_cast<int>(columns));
    for (int run = 0; run < runs; ++run) {
        const Weights digit =
            base == 2 ? Weights{run / 3, run % 3, 0} : Weights{run / 9, run / 3 % 3, run % 3};
        for (std::size_t k = 0; k < columns; ++k) {
            const int level =
                (weights[k][0] * digit[0] + weights[k][1] * digit[1] + weights[k][2] * digit[2]) %
                3;
            design(run, static_cast<int>(k)) = level - 1.0;
        }
    }
    return design;
}

Eigen::MatrixXd l18() {
    Eigen::MatrixXd design(18, 8);
    for (int run = 0; run < 18; ++run) {
        const std::string_view row = l18_rows[static_cast<std::size_t>(run)];
        design(run, 0) = row[0] == '1' ? -1.0 : 1.0;
        for (int k = 1; k < 8; ++k) design(run, k) = row[static_cast<std::size_t>(k)] - '2';
    }
    return design;
}

}  // namespace

Eigen::MatrixXd plackett_burman(int runs) {
    for (const std::string_view row : first_rows) {
        const int columns = static_cast<int>(row.size());
        if (columns + 1 != runs) continue;
        Eigen::MatrixXd design = Eigen::MatrixXd::Constant(runs, columns, -1.0);
        for (int run = 0; run < columns; ++run) {
            for (int k = 0; k < columns; ++k) {
                const int shifted = (k - run + columns) % columns;
                if (row[static_cast<std::size_t>(shifted)] == '+') design(run, k) = 1.0;
            }
        }
        return design;
    }
    throw scaling::InvalidParameter(scaling::mistake("plackett_burman.runs", std::to_string(runs),
                                                     "must be 8, 12, 16, 20, 24 or 36",
                                                     "take the next larger one"));
}

Eigen::MatrixXd orthogonal_array(int runs) {
    if (runs == 9) return sums_modulo_3(l9_columns, 2);
    if (runs == 18) return l18();
    if (runs == 27) return sums_modulo_3(l27_columns, 3);
    throw scaling::InvalidParameter(scaling::mistake("orthogonal_array.runs", std::to_string(runs),
                                                     "must be 9, 18 or 27",
                                                     "two-level arrays are plackett_burman's"));
}

}  // namespace calibrate
