// SPDX-License-Identifier: MIT
#include "samples.hpp"

#include "scaling/numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace {

using namespace scaling;

verify::PileSample cone_sample(std::uint64_t seed, double steepness) {
    verify::PileSample s;
    s.name = "sample-" + std::to_string(seed);
    s.seed = seed;
    s.formed = s.at_rest = true;
    s.angles_deg.fill(30.0 + steepness);
    s.packing_fraction = 0.55 + 0.001 * steepness;
    s.coordination = 4.0 + 0.01 * steepness;
    s.grains_on_base = 1400;
    for (double r = 0.125; r < 10.0; r += 0.25) {
        s.profile_r.push_back(r);
        s.profile_z.push_back((10.0 - r) * std::tan((30.0 + steepness) * 0.0174533));
    }
    s.hash = 0x0123456789abcdefu;
    return s;
}

verify::Side side(const char* label, double diameter, double first) {
    verify::Side s{label, diameter, 9.81, 6.6e3 * diameter / 1.2e-6, 9.5e-6, 270.2, 1e5, {}};
    for (std::uint64_t k = 0; k < 3; ++k)
        s.samples.push_back(cone_sample(k + 1, first + static_cast<double>(k)));
    return s;
}

verify::Quantity quantity(const char* name, const char* unit, const std::vector<double>& a,
                          const std::vector<double>& b, double margin) {
    verify::Quantity q{};
    q.name = name;
    q.unit = unit;
    q.reference = statistics::summary(a);
    q.scaled = statistics::summary(b);
    q.test = statistics::two_one_sided_tests(q.reference, q.scaled, margin);
    q.seeds_for_power = 12;
    return q;
}

}  // namespace

ScaleStudy zirconia_study(const std::string& scheme) {
    ScaleInput in{};
    in.grain = {.diameter = 1.2e-6 * si::meters,
                .density = 5600.0 * si::kilogrammes_per_cubic_metre,
                .youngs_modulus = youngs_modulus(60e6 * si::pascals, 0.3),
                .poisson_ratio = 0.3,
                .gravity = 9.81 * si::meters_per_second_squared,
                .drop_height = 65e-3 * si::meters};
    in.apparatus_length = 6e-3 * si::meters;
    in.base_diameter = 80e-3 * si::meters;
    in.adhesion = StatedAdhesion{0.38 * si::newtons_per_meter, Of::scaled};
    in.coefficients = {{"restitution", 0.225}};
    in.scheme = named_scheme(scheme);
    in.h = 200.0;
    if (in.scheme.distorted) in.invariant = Invariant::weight_bond;
    return study(in);
}

reports::Verification cone_verification() {
    reports::Verification v;
    v.checks = {verify::check_relative({"two spheres part at 3/2 pi w R*", "adhesion", "N",
                                        "algebra", "Johnson, Kendall & Roberts (1971)"},
                                       1.0, 1.0, 1e-12),
                verify::check_absolute(
                    {"a stone falls for a second", "flight", "s", "one step of 1 ms", ""}, 1.0,
                    1.0004, 1e-3)};
    verify::Comparison c{.name = "kept_gravity, h = 200",
                         .what_differs = "the scale alone",
                         .reference = side("reference", 1.2e-6, -1.0),
                         .scaled = side("scaled", 240e-6, -0.8),
                         .quantities = {},
                         .answer = verify::Answer::not_decided,
                         .must_differ = false,
                         .claims = false};
    c.quantities = {
        quantity("angle_of_repose", "deg", {29.0, 30.0, 31.0}, {29.2, 30.2, 31.2}, 2.5),
        quantity("packing_fraction", "1", {0.549, 0.55, 0.551}, {0.5492, 0.5502, 0.5512}, 0.01),
        quantity("coordination", "1", {3.99, 4.0, 4.01}, {3.992, 4.002, 4.012}, 0.15)};
    verify::SimilarityResult result{};
    result.bits = {{"exact", 256.0, 1400, 1, 1, true}, {"kept_gravity", 256.0, 1400, 1, 1, true}};
    result.comparisons = {c};
    v.similarity = result;
    return v;
}

std::string fault_in_markup(const std::string& text) {
    static const std::array<std::string, 6> alone{"meta", "br",       "link",
                                                  "img",  "!doctype", "!DOCTYPE"};
    std::vector<std::string> open;
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
        const std::size_t end = text.find('>', at);
        if (end == std::string::npos) return "a tag without an end";
        const bool closing = text[at + 1] == '/', empty = text[end - 1] == '/';
        const std::size_t from = at + (closing ? 2 : 1);
        const std::string name = text.substr(from, text.find_first_of(" \n/>", from) - from);
        at = end;
        if (closing) {
            if (open.empty() || open.back() != name)
                return "</" + name + "> where " + (open.empty() ? "nothing" : open.back()) +
                       " is open";
            open.pop_back();
        } else if (!empty && std::find(alone.begin(), alone.end(), name) == alone.end()) {
            open.push_back(name);
        }
        if (!closing && (name == "style" || name == "script")) at = text.find("</" + name, at);
    }
    return open.empty() ? "" : "<" + open.back() + "> is never closed";
}

std::size_t times_in(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos;
         at = text.find(part, at + part.size()))
        ++found;
    return found;
}
