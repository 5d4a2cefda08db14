// SPDX-License-Identifier: MIT
#include "prove/case_text.hpp"

#include "prove/dice.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace prove {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

struct Written {
    const char* name;
    double si;  // of one of it
};

// The unit of a whole column, by its largest value.
Written unit_for(const std::string& si, double size) {
    static constexpr std::array<Written, 3> lengths{{{"mm", 1e-3}, {"um", 1e-6}, {"nm", 1e-9}}};
    static constexpr std::array<Written, 3> forces{{{"mN", 1e-3}, {"uN", 1e-6}, {"nN", 1e-9}}};
    const auto& list = si == "N" ? forces : lengths;
    if (si == "rad") return {"deg", degree};
    if (si == "s") return {"s", 1.0};
    if (si != "m" && si != "N") return {si == "1" ? "1" : si.c_str(), 1.0};
    for (const Written& u : list)
        if (size >= 0.5 * u.si || u.si == 1e-9) return u;
    return list.back();
}

double largest(const double* values, std::size_t n) {
    double size = 0.0;
    for (std::size_t k = 0; k < n; ++k)
        if (std::isfinite(values[k])) size = std::max(size, std::abs(values[k]));
    return size;
}

std::string member(const char* name, const std::string& value) {
    return fmt::format("{}: {}", json_text(name), value);
}

// A condition, with the deviation of its prior where there is one.
std::string condition(const char* name, double value, const std::string& unit,
                      const std::vector<Unknown>& nuisances, int index, double Setup::*place) {
    const Written u = unit_for(unit, std::abs(value));
    const auto text = [&](double x) {
        return unit == "s" ? json_text(fmt::format("{:.6g} ms", x / 1e-3))
                           : json_text(fmt::format("{:.7g} {}", x / u.si, u.name));
    };
    for (const Unknown& n : nuisances)
        if (n.in_setup == place && n.experiment == index)
            return member(name, fmt::format("{{\"value\": {}, \"uncertainty\": {}}}", text(value),
                                            text(n.deviation)));
    return member(name, text(value));
}

std::string joined(const std::vector<std::string>& parts, const char* between) {
    std::string all;
    for (const std::string& p : parts) all += (all.empty() ? "" : between) + p;
    return all;
}

std::string grain_text(const Setup& s) {
    return fmt::format(
        "{{\"diameter\": {}, \"density\": \"{:.6g} kg/m^3\", \"youngs_modulus\": \"{:.6g} MPa\", "
        "\"poisson_ratio\": {:.4g}}}",
        json_text(quantity(s.diameter, "m")), s.density, s.youngs_modulus / 1e6, s.poisson_ratio);
}

std::vector<std::string> conditions(const Setup& s, const std::vector<Unknown>& n, int k) {
    std::vector<std::string> all;
    const auto add = [&](const char* name, double Setup::*place, const char* unit, bool always) {
        bool uncertain = false;
        for (const Unknown& u : n) uncertain |= u.in_setup == place && u.experiment == k;
        if (always || uncertain || s.*place != 0.0)
            all.push_back(condition(name, s.*place, unit, n, k, place));
    };
    switch (s.rig) {
        case Rig::drop:
            add("height", &Setup::height, "m", true);
            add("speed", &Setup::speed, "m/s", false);
            add("horizontal_speed", &Setup::horizontal_speed, "m/s", false);
            add("spin", &Setup::spin, "rad/s", false);
            add("release_time", &Setup::release_time, "s", false);
            break;
        case Rig::incline:
            add("angle", &Setup::angle, "rad", true);
            add("speed", &Setup::speed, "m/s", true);
            add("spin", &Setup::spin, "rad/s", true);
            break;
        case Rig::impact:
            add("speed", &Setup::speed, "m/s", true);
            add("spin", &Setup::spin, "rad/s", false);
            break;
        case Rig::pull_off:
            all.push_back(member("counterpart", s.grain_on_grain ? "\"grain\"" : "\"plate\""));
            all.push_back(member("preload", json_text(quantity(s.preload, "N"))));
            if (s.cantilever_stiffness > 0.0)
                all.push_back(member("cantilever_stiffness",
                                     json_text(fmt::format("{:.6g} N/m", s.cantilever_stiffness))));
    }
    return all;
}

std::string parameters_text(const Skeleton& sk) {
    std::vector<std::string> all;
    for (const Stated& p : sk.parameters) {
        const std::string unit = unit_of_parameter(p.name);
        const auto text = [&](double x) {
            return unit == "1" ? fmt::format("{:.6g}", x)
                               : json_text(fmt::format("{:.6g} {}", x, unit));
        };
        all.push_back(
            member(p.name.c_str(), p.free ? fmt::format("{{\"value\": {}, \"range\": [{}, {}]}}",
                                                        text(p.start), text(p.low), text(p.high))
                                          : fmt::format("{{\"value\": {}}}", text(p.start))));
    }
    return joined(all, ", ");
}

}  // namespace

std::string quantity(double si, const std::string& unit) {
    const Written u = unit_for(unit, std::abs(si));
    return fmt::format("{:.7g} {}", si / u.si, u.name);
}

std::string json_text(const std::string& plain) {
    std::string out = "\"";
    for (const char c : plain) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + "\"";
}

std::string recording_text(const Setup& s, const double* values) {
    const std::size_t rows = s.at.size();
    const std::string ordinate = ordinate_of(s);
    const Written at = unit_for(s.rig == Rig::impact     ? "rad"
                                : s.rig == Rig::pull_off ? "m"
                                                         : "s",
                                largest(s.at.data(), rows));
    std::string text = fmt::format("{} [{}]", ordinate, at.name);
    std::vector<Written> units;
    for (std::size_t c = 0; c < s.recorded.size(); ++c) {
        const std::string si = unit_of(s.recorded[c]);
        units.push_back(unit_for(si, largest(values + c * rows, rows)));
        text += fmt::format(",{} [{}]", to_string(s.recorded[c]),
                            si == "rad/s" ? "rad/s" : units.back().name);
    }
    text += s.rig == Rig::pull_off ? ",branch\n" : "\n";
    for (std::size_t k = 0; k < rows; ++k) {
        text += fmt::format("{:.6g}", s.at[k] / at.si);
        for (std::size_t c = 0; c < s.recorded.size(); ++c) {
            const double y = values[c * rows + k];
            text += std::isfinite(y) ? fmt::format(",{:.6g}", y / units[c].si) : std::string(",");
        }
        if (s.rig == Rig::pull_off) text += s.retract[k] ? ",retract" : ",approach";
        text += "\n";
    }
    return text;
}

std::string experiment_text(const Setup& s, const Setup& common,
                            const std::vector<Unknown>& nuisances, int index, bool states_noise,
                            bool simulated) {
    std::vector<std::string> parts{
        member("id", json_text(s.id)), member("rig", json_text(to_string(s.rig))),
        member("conditions", fmt::format("{{{}}}", joined(conditions(s, nuisances, index), ", ")))};
    if (s.diameter != common.diameter || s.density != common.density ||
        s.youngs_modulus != common.youngs_modulus || s.poisson_ratio != common.poisson_ratio)
        parts.push_back(member("grain", grain_text(s)));
    parts.push_back(member("recording", json_text(s.id + ".csv")));
    if (simulated) parts.push_back(member("simulated", json_text(s.id + "-simulated.csv")));
    if (states_noise) {
        std::vector<std::string> noise;
        for (std::size_t c = 0; c < s.recorded.size(); ++c) {
            const std::string unit = unit_of(s.recorded[c]);
            noise.push_back(member(to_string(s.recorded[c]),
                                   unit == "1" ? fmt::format("{:.4g}", s.noise[c])
                                               : json_text(quantity(s.noise[c], unit))));
        }
        parts.push_back(member("noise", fmt::format("{{{}}}", joined(noise, ", "))));
    }
    parts.push_back(member("role", s.held_out ? "\"held_out\"" : "\"fit\""));
    return fmt::format("{{{}}}", joined(parts, ", "));
}

std::map<std::string, std::string> case_files(const Skeleton& sk, const std::string& name,
                                              const std::string& numerics,
                                              const Eigen::VectorXd& recordings,
                                              const Eigen::VectorXd& simulated) {
    std::map<std::string, std::string> files;
    const Setup& common = sk.stated.front();
    std::vector<std::string> experiments;
    std::size_t first = 0;
    for (std::size_t e = 0; e < sk.stated.size(); ++e) {
        const Setup& s = sk.stated[e];
        const bool own_run = simulated.size() > 0 && !s.held_out;
        experiments.push_back("    ");
        experiments.back().append(experiment_text(s, common, sk.nuisances, static_cast<int>(e),
                                                  sk.states_noise, own_run));
        files[s.id + ".csv"] = recording_text(s, recordings.data() + first);
        if (own_run) files[s.id + "-simulated.csv"] = recording_text(s, simulated.data() + first);
        first += s.size();
    }
    std::vector<std::string> physics;
    for (const std::string& p : sk.physics) physics.push_back(json_text(p));
    files["case.json"] = fmt::format(
        "{{\n  \"format\": \"similitude-case/1\",\n  \"title\": {},\n  \"grain\": {},\n"
        "  \"plate\": {{\"youngs_modulus\": \"{:.6g} GPa\", \"poisson_ratio\": {:.4g}}},\n"
        "  \"surroundings\": {{\"gravity\": \"{:.6g} m/s^2\", \"fluid_density\": \"{:.6g} "
        "kg/m^3\", "
        "\"fluid_viscosity\": \"{:.6g} Pa*s\"}},\n"
        "  \"model\": {{\"physics\": [{}],\n    \"parameters\": {{{}}}{}}},\n"
        "  \"experiments\": [\n{}\n  ]\n}}\n",
        json_text(name), grain_text(common), common.plate_youngs_modulus / 1e9,
        common.plate_poisson_ratio, common.gravity, common.fluid_density, common.fluid_viscosity,
        joined(physics, ", "), parameters_text(sk),
        numerics.empty() ? "" : ",\n    \"numerics\": " + numerics, joined(experiments, ",\n"));
    return files;
}

}  // namespace prove
