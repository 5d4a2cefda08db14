// SPDX-License-Identifier: MIT
#include "calibrate/published.hpp"

#include "cases/json_tree.hpp"
#include "scaling/errors.hpp"
#include "scaling/quantities.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace calibrate {

namespace {

using cases::Value;

constexpr const char* format = "similitude-published/1";
constexpr const char* file_name = "published.json";

Printed printed(const Value& v) {
    const std::string& text = v.text();
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || (*end != '\0' && *end != ' '))
        cases::refuse(v, "must begin with a number", "write it as printed, such as \"22.000\"");
    return {text, value};
}

std::optional<Printed> optional_printed(const Value& v) {
    if (v.text().empty()) return std::nullopt;
    return printed(v);
}

const std::vector<Value>& items(const Value& v, std::size_t count = 0) {
    if (v.kind != Value::Kind::list || (count > 0 && v.items.size() != count))
        cases::refuse(v, count > 0 ? fmt::format("must be a list of {}", count) : "must be a list",
                      "see docs/calibrate.md");
    return v.items;
}

std::vector<std::string> texts(const Value& v) {
    std::vector<std::string> list;
    for (const Value& item : items(v)) list.push_back(item.text());
    return list;
}

double metres(const Value& v) { return v.quantity<scaling::Length>().value(); }

PublishedExperiment experiment_of(const Value& v) {
    PublishedExperiment e{v.at("table").text(),          {},
                          printed(v.at("target")),       metres(v.at("outlet_diameter")),
                          metres(v.at("top_diameter")),  metres(v.at("cone_height")),
                          metres(v.at("outlet_height")), metres(v.at("base_diameter"))};
    for (const Value& reading : items(v.at("readings"))) e.readings.push_back(reading.number());
    return e;
}

PublishedFactor factor_of(const Value& v) {
    const std::vector<Value>& range = items(v.at("range"), 2);
    PublishedFactor f{v.at("letter").text(),
                      v.at("name").text(),
                      v.has("unit") ? v.at("unit").text() : "",
                      v.at("low").number(),
                      v.at("high").number(),
                      range[0].number(),
                      range[1].number(),
                      optional_printed(v.at("fixed"))};
    if (!(f.low < f.high)) cases::refuse(v.at("high"), "must be above low", "swap the levels");
    return f;
}

Trials screening_of(const Value& v, std::size_t factors) {
    const std::vector<Value>& runs = items(v.at("runs"));
    Trials trials{
        Eigen::MatrixXd(static_cast<Eigen::Index>(runs.size()), static_cast<Eigen::Index>(factors)),
        {}};
    for (std::size_t run = 0; run < runs.size(); ++run) {
        const std::vector<Value>& row = items(runs[run], 2);
        const std::vector<Value>& levels = items(row[0], factors);
        for (std::size_t k = 0; k < factors; ++k) {
            const double level = levels[k].number();
            if (std::abs(level) != 1.0) cases::refuse(levels[k], "must be -1 or 1", "code it");
            trials.design(static_cast<Eigen::Index>(run), static_cast<Eigen::Index>(k)) = level;
        }
        const bool failed = row[1].text() == "not formed";
        trials.responses.push_back(failed ? std::nullopt
                                          : std::optional<double>(printed(row[1]).value));
    }
    return trials;
}

PublishedEffect effect_of(const Value& v) {
    const std::vector<Value>& c = items(v, 9);
    return {c[0].text(),   printed(c[1]), printed(c[2]), printed(c[3]), printed(c[4]),
            printed(c[5]), printed(c[6]), printed(c[7]), printed(c[8])};
}

// Rows of values and either a response with its error, or "formed" and "not formed".
PublishedTable table_of(const Value& v) {
    PublishedTable t{v.at("table").text(), texts(v.at("factors")), {}};
    for (const Value& row : items(v.at("rows"))) {
        const std::vector<Value>& cells = items(row);
        PublishedRow r{{}, std::nullopt, std::nullopt, true};
        for (const Value& value : items(cells.at(0), t.factors.size()))
            r.values.push_back(printed(value));
        const std::string& came = items(row, cells.size() == 3 ? 3 : 2)[1].text();
        r.formed = came != "not formed";
        if (r.formed && came != "formed") r.response = printed(cells[1]);
        if (cells.size() == 3) r.relative_error = printed(cells[2]);
        t.rows.push_back(r);
    }
    return t;
}

PublishedLine line_of(const Value& v, std::size_t rows) {
    const std::vector<Value>& runs = items(v.at("runs"), 2);
    for (const Value& run : runs)
        if (static_cast<std::size_t>(run.count()) > rows)
            cases::refuse(run, fmt::format("must be at most {}", rows), "a row of `orthogonal`");
    return {v.at("table").text(),
            static_cast<int>(runs[0].count()),
            static_cast<int>(runs[1].count()),
            printed(v.at("slope")),
            printed(v.at("intercept")),
            printed(v.at("solution"))};
}

void read_confirmed(const Value& v, Published& p) {
    p.confirmed_table = v.at("table").text();
    p.confirmed = printed(v.at("angle"));
    p.confirmed_error = printed(v.at("relative_error"));
    for (const Value& pair : items(v.at("values"))) {
        const std::vector<Value>& cells = items(pair, 2);
        p.confirmed_values.emplace_back(cells[0].text(), cells[1].number());
    }
}

void read_screening(const Value& top, Published& p) {
    for (const Value& f : items(top.at("factors").at("list"))) p.factors.push_back(factor_of(f));
    p.screening_table = top.at("screening").at("table").text();
    p.screening = screening_of(top.at("screening"), p.factors.size());
    const Value& effects = top.at("main_effects");
    p.effects_table = effects.at("table").text();
    p.claimed = texts(effects.at("claimed"));
    for (const Value& row : items(effects.at("rows"), p.factors.size()))
        p.effects.push_back(effect_of(row));
}

}  // namespace

bool Printed::agrees(double exact) const {
    const std::size_t end = text.find(' '), e = text.find('e');
    const std::string mantissa = text.substr(0, std::min(end, e));
    const std::size_t point = mantissa.find('.');
    const int decimals =
        point == std::string::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
    const int exponent = e == std::string::npos ? 0 : std::atoi(text.c_str() + e + 1);
    const double last = std::pow(10.0, exponent - decimals);
    // 1e-6 of the last digit for what binary makes of a decimal half.
    return std::abs(exact - value) <= (0.5 + 1e-6) * last;
}

const PublishedFactor& Published::factor(const std::string& letter) const {
    for (const PublishedFactor& f : factors)
        if (f.letter == letter) return f;
    throw scaling::InvalidInput(scaling::mistake(path + ": factors", '"' + letter + '"',
                                                 "must be one of the factors", "add it"));
}

double Published::confirmed_value(const std::string& letter) const {
    for (const auto& [known, value] : confirmed_values)
        if (known == letter) return value;
    throw scaling::InvalidInput(scaling::mistake(path + ": confirmed.values", '"' + letter + '"',
                                                 "must be among the values", "add it"));
}

Published read_published(const std::string& case_path) {
    const std::filesystem::path given(case_path);
    const std::filesystem::path folder =
        std::filesystem::is_directory(given) ? given : given.parent_path();
    const std::filesystem::path path = folder / file_name;
    if (!std::filesystem::exists(path))
        throw scaling::InvalidInput(scaling::mistake(
            path.string(), "no such file", "must hold the published calibration of this case",
            "docs/calibrate.md says what it holds; data/zirconia has one"));
    const Value top = cases::read_json(path.string());
    if (top.at("format").text() != format)
        cases::refuse(top.at("format"), fmt::format("must be \"{}\"", format), "write that");
    Published p{};
    p.path = path.string();
    p.title = top.at("title").text();
    p.source = top.at("source").text();
    p.restored = texts(top.at("restored"));
    p.response = top.at("response").at("name").text();
    p.unit = top.at("response").at("unit").text();
    p.failure = top.at("response").at("failure").text();
    p.experiment = experiment_of(top.at("experiment"));
    read_screening(top, p);
    p.ascent = table_of(top.at("ascent"));
    for (const Value& step : items(top.at("ascent").at("steps"), p.ascent.factors.size()))
        p.ascent_steps.push_back(step.number());
    p.second_ascent = table_of(top.at("second_ascent"));
    p.orthogonal = table_of(top.at("orthogonal"));
    p.line = line_of(top.at("interpolation"), p.orthogonal.rows.size());
    read_confirmed(top.at("confirmed"), p);
    const Value& simulation = top.at("simulation");
    p.simulation_table = simulation.at("table").text();
    p.simulated_base = metres(simulation.at("base_diameter"));
    p.scale_number = printed(simulation.at("scale_number"));
    p.time_step = printed(simulation.at("time_step"));
    p.rayleigh_percent = printed(simulation.at("rayleigh_percent"));
    return p;
}

}  // namespace calibrate
