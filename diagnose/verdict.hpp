// SPDX-License-Identifier: MIT
// What a diagnosis says: the format `similitude-verdict/1` as a struct, and what a report needs besides. Raw doubles are SI
// unless a unit stands beside them.
#pragma once

#include "diagnose/unknowns.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace diagnose {

enum class Answer {
    consistent,   // nothing left out that these recordings can show
    explained,    // one or more effects named
    ambiguous,    // a mismatch, and two or more hypotheses that fit alike
    unexplained,  // a mismatch, and nothing in the catalogue explains it
    undecided     // these recordings cannot show left-out physics
};

const char* to_string(Answer);

// Where recorded and simulated (the refitted base model) differ: the shortest interval of the channel's own ordinate that
// holds 80 % of the squared, whitened mismatch.
struct Located {
    std::string experiment, channel;
    std::string variable, unit;  // of from and to, SI
    double from, to;
    int sign;     // of recorded minus simulated, weighted by size
    double size;  // rms of the mismatch in the interval
    std::string size_unit;
    double p_value;  // one global p-value for the whole case
};

struct Estimate {
    std::string name, unit;  // SI
    double value;
    double low, high;  // 90 % interval
};

struct Hypothesis {
    std::vector<std::string> effects;  // empty: none; {"unknown"}: none of these
    double probability;
};

enum class GateResult { passed, failed, untestable };

const char* to_string(GateResult);

struct Gate {
    std::string name;  // range, regimes, scaling, placebo, refinement, own_mismatch
    GateResult result;
    std::string why;  // one sentence
};

// What is missing, as a function of one variable of the state.
struct MissingEstimate {
    std::string variable, unit;             // of the knots, SI
    std::vector<double> knots;              // rising
    std::vector<double> values, low, high;  // 90 % band
    std::string words;  // "an attraction to the plate that grows as the fourth power near it"
    Missing of = Missing::force;
    std::string unit_of_values = "N";  // SI
    std::string channel{};             // that drifts
    std::string what() const {
        return of == Missing::force ? "force" : of == Missing::drift ? "drift" : "restitution";
    }
};

struct Effect {
    std::string name;
    double probability;  // marginal
    bool named = false;
    std::vector<Estimate> parameters;
    std::vector<Gate> gates;
    std::vector<std::string> why;
    std::optional<MissingEstimate> missing;  // of "unknown"
};

// 100 rms(simulated - recorded)/(max - min of the recorded channel), mean over experiments and channels.
struct Scores {
    double nrmse_base, nrmse_extended, noise_floor;  // %
    std::vector<std::string> experiments;
};

struct NextExperiment {
    std::string rig;
    std::map<std::string, std::string> conditions;  // as in case.json, with units
    std::map<std::string, std::string> grain;       // what to change of the grain; may be empty
    std::vector<std::string> channels;
    std::string ordinate, ordinate_unit;  // SI
    double from, to;
    int rows;
    std::map<std::string, double> noise;  // SI, that it was planned with
    std::vector<std::string>
        between;              // the hypotheses that it tells apart, as "air_drag" or "a + b"
    double separation_sigma;  // expected
    std::string why;
};

// For plots and --predict. Shape of all: [rows].
struct PredictedCurve {
    std::string experiment, channel, unit;
    bool held_out;
    std::string ordinate, ordinate_unit;
    std::vector<double> at;
    std::vector<std::string> branch;  // pull_off; else empty
    std::vector<double> recorded, base, extended;
    double noise;  // standard deviation
};

struct Verdict {
    std::string title;
    std::uint64_t seed;
    Answer answer;
    double p_value;  // global
    std::vector<Located> located;
    std::vector<Hypothesis> hypotheses;           // falling probability, sum 1
    std::vector<std::vector<std::string>> alike;  // names of those that cannot be told apart
    std::vector<Effect> effects;                  // falling probability
    std::optional<Scores> fit, held_out;
    std::vector<Estimate> refitted;
    std::optional<NextExperiment> next_experiment;
    std::vector<std::string> warnings;
    std::vector<std::string> summary;  // plain words, a sentence each
    std::vector<std::string> flips;    // what would change the verdict, a sentence each
    std::vector<PredictedCurve> curves;
    double noise_correlation = 0.0;  // of neighbouring rows, largest of the channels
};

}  // namespace diagnose
