// SPDX-License-Identifier: MIT
// A calibration as it was published, digit by digit: what `published.json` beside a case holds
// (docs/calibrate.md). Two-level screening, main effects, ascents, a two-factor orthogonal test,
// interpolation, a confirming run.
#pragma once

#include "calibrate/trials.hpp"

#include <optional>
#include <string>
#include <vector>

namespace calibrate {

// A number with the digits in which it was printed: "22.000", "7.78e-7 s".
struct Printed {
    std::string text;
    double value;  // in the unit of the text

    // Whether `exact`, rounded to as many digits, is what was printed. Halves may go either way.
    bool agrees(double exact) const;
};

struct PublishedFactor {
    std::string letter, name, unit;
    double low, high;              // of the screening
    double range_low, range_high;  // in which the factor may lie
    std::optional<Printed> fixed;  // value while other factors were varied

    double coded(double value) const { return (value - 0.5 * (low + high)) / (0.5 * (high - low)); }
};

// One row of a table of level means (effects.hpp).
struct PublishedEffect {
    std::string factor;
    Printed sum_high, count_high, mean_high, sum_low, count_low, mean_low, effect, rank;
};

struct PublishedRow {
    std::vector<Printed> values;                      // of `factors`
    std::optional<Printed> response, relative_error;  // %; neither where only "formed" is known
    bool formed;
};

struct PublishedTable {
    std::string table;                 // "Table 9"
    std::vector<std::string> factors;  // letters
    std::vector<PublishedRow> rows;
};

struct PublishedLine {
    std::string table;
    int first, second;  // rows of the orthogonal table, from 1
    Printed slope, intercept, solution;
};

// The apparatus and readings behind the target. SI; angles in deg.
struct PublishedExperiment {
    std::string table;
    std::vector<double> readings;
    Printed target;
    double outlet_diameter, top_diameter, cone_height, outlet_height, base_diameter;  // m
};

struct Published {
    std::string path, title, source;
    std::vector<std::string> restored;  // digits that the copy read does not show, and why
    std::string response, unit, failure;
    PublishedExperiment experiment;
    std::vector<PublishedFactor> factors;
    std::string screening_table, effects_table;
    Trials screening;
    std::vector<PublishedEffect> effects;
    std::vector<std::string> claimed;  // factors, the largest effect first
    PublishedTable ascent;
    std::vector<double> ascent_steps;  // of `ascent.factors`
    PublishedTable second_ascent, orthogonal;
    PublishedLine line;
    std::string confirmed_table;
    Printed confirmed, confirmed_error;
    std::vector<std::pair<std::string, double>> confirmed_values;  // letter, value
    std::string simulation_table;
    double simulated_base;  // m
    Printed scale_number, time_step, rayleigh_percent;

    const PublishedFactor& factor(const std::string& letter) const;
    double confirmed_value(const std::string& letter) const;
};

// Reads the file that stands beside case.json. Throws scaling::InvalidInput, one line.
Published read_published(const std::string& case_path);

}  // namespace calibrate
