// SPDX-License-Identifier: MIT
// One blind case and its key. Everything follows from (seed, number) alone; shares, kinds and figures: docs/prove.md.
#pragma once

#include "prove/figures.hpp"
#include "prove/separation.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace prove {

enum class Kind { null, single, look_alike, pair, outside, numerical };
const char* to_string(Kind);
Kind kind_of(const std::string&);  // throws scaling::InvalidInput for another word

// What is decided before anything is drawn.
struct Plan {
    Kind kind;
    std::string
        subkind;  // of a null: white, heavy, correlated, mis_set; of a pair: cancelling or plain
    std::string
        effect;  // to be concealed, or (null, outside, numerical) the one whose skeleton is used
    Rig rig;
    double target;  // IDR
};
Plan plan(std::uint64_t seed, int number);
// The same kind with another effect, where the first could not be hidden.
Plan another(const Plan&, std::uint64_t seed, int number, int round);

struct TrueParameter {
    std::string effect, channel, name, unit;  // SI
    double value;
    double
        oracle_error;  // standard error of a fit that knows the term, of the recordings with role fit
};

struct Key {
    std::string name;  // "case-0001"
    Kind kind;
    std::string subkind, rig;
    std::vector<std::string> effects;   // empty: null; "unknown"; "numerical_artefact"
    std::vector<std::string> channels;  // of measurement effects, else ""
    std::string outside;                // in words, of the kind outside
    std::vector<TrueParameter> parameters;
    double idr = 0.0, n_eff = 0.0, lambda = 0.0, oracle_power = 0.0;
    double oracle_statistic =
        0.0;  // likelihood ratio on the recordings as they are, true term against none
    int oracle_freedom = 0;
    Separation separation{};
    double pair_separation = 0.0;            // kinds outside and pair
    std::vector<double> lambda_given_other;  // kind pair, in the order of effects
    std::vector<TrueInterval> intervals;
    int recorded_channels = 1;
    double oracle_held_out = 0.0, base_held_out = 0.0, noise_floor = 0.0;  // nrmse, %
    Noise noise;
};

struct BlindCase {
    int number = 0;
    std::map<std::string, std::string> files;  // name in the folder -> content
    Key key;
    std::string key_text;        // JSON
    Skeleton skeleton;           // for further recordings
    World world;                 // with the secret
    Eigen::VectorXd recordings;  // as recorded, shape of predict() over all experiments
};

// Without figures the key says what is concealed and no more: the files are the same. Throws std::runtime_error where no case
// of that kind was found.
enum class Figures { all, none };
BlindCase make_case(std::uint64_t seed, int number, Figures = Figures::all);

// FOLDER/case-0001/... and KEYS/case-0001.json. Throws std::runtime_error where a file cannot be written.
void write(const BlindCase&, const std::string& folder, const std::string& keys);

std::string case_name(int number);

}  // namespace prove
