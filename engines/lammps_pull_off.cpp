// SPDX-License-Identifier: MIT
#include "engines/lammps_pull_off.hpp"

#include "engines/lammps_contact.hpp"
#include "engines/lammps_files.hpp"
#include "engines/lammps_rules.hpp"
#include "engines/pile_feed.hpp"
#include "rigs/one_grain.hpp"
#include "rigs/single_grain.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace engines {
namespace {

using dem_min::Grain;
using rigs::OneGrain;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// Where the upper grain is at each step from 1 on, and at which step a row is; 0 of a row that is no number.
struct Way {
    std::vector<double> separation;      // m, [steps]
    std::vector<std::int64_t> row_step;  // [ordinates]
};

OneGrain grain_of(const cases::Case& c, const cases::Experiment& e) {
    const bool plate = e.conditions.at("counterpart").text() != "grain";
    return rigs::one_grain(rigs::Stated(e), rigs::world_of(c, e),
                           plate ? rigs::Counterpart::plate : rigs::Counterpart::grain);
}

double sphere_radius(const OneGrain& g) { return 2.0 * g.r_star; }

void refuse_what_it_has_not(const cases::Case& c, const cases::Experiment& e,
                            const DeckOptions& o) {
    const rigs::World world = rigs::world_of(c, e);
    for (const std::string& effect : rigs::pull_off_effects())
        if (world.physics.count(effect) > 0 && effect != "hertz_mindlin" && effect != "adhesion")
            refuse(o, "lammps", fmt::format("is told of no {} in a pull-off", effect), ours);
    if (!grain_of(c, e).compliant)
        refuse(o, "lammps", "has no rigid grains", "list hertz_mindlin in model.physics");
    if (rigs::ordinate_name(e) == "displacement" &&
        std::isfinite(rigs::Stated(e).value({}, "conditions.cantilever_stiffness",
                                            std::numeric_limits<double>::infinity())))
        refuse(o, "lammps", "is told of no cantilever (conditions.cantilever_stiffness)",
               "record force against separation, or leave the option out");
}

// In, outermost first; past the turning point, where the contact is made at the latest; out again.
Way way_of(const cases::Experiment& e, const rigs::Ordinates& at, const OneGrain& g) {
    const double origin = rigs::ordinate_name(e) == "displacement"
                              ? rigs::Stated(e).value({}, "conditions.contact_displacement", 0.0)
                              : 0.0;
    std::vector<std::pair<double, std::size_t>> in, out;
    double turn = -1e-6 * g.r_star;
    for (std::size_t k = 0; k < at.at.size(); ++k) {
        if (!std::isfinite(at.at[k])) continue;
        const double s = at.at[k] - origin;
        const bool retract = k < at.retract.size() && at.retract[k];
        (retract ? out : in).emplace_back(s, k);
        turn = std::min(turn, s);
    }
    std::sort(in.rbegin(), in.rend());
    std::sort(out.begin(), out.end());
    Way way{{}, std::vector<std::int64_t>(at.at.size(), 0)};
    const auto go = [&](const std::vector<std::pair<double, std::size_t>>& rows) {
        for (const auto& [s, row] : rows) {
            way.separation.push_back(s);
            way.row_step[row] = static_cast<std::int64_t>(way.separation.size());
        }
    };
    go(in);
    way.separation.push_back(turn);
    go(out);
    return way;
}

// Before the first step, m: apart, and farther than any row.
double start_gap(const Way& way, const OneGrain& g) {
    return 0.5 * g.r_star +
           std::max(0.0, *std::max_element(way.separation.begin(), way.separation.end()));
}

// `next` reads a line ahead, so the last stands twice.
std::string way_text(const Way& way, double start) {
    std::string text;
    for (const double s : way.separation) text += fmt::format("{:.17g}\n", s - start);
    return text + fmt::format("{:.17g}\n", way.separation.back() - start);
}

}  // namespace

Deck lammps_pull_off(const cases::Case& c, const cases::Experiment& e, const rigs::Ordinates& at,
                     const DeckOptions& o) {
    refuse_what_it_has_not(c, e, o);
    const OneGrain g = grain_of(c, e);
    const Way way = way_of(e, at, g);
    const double radius = sphere_radius(g), start = start_gap(way, g);
    const LammpsContact contact{.youngs_modulus = 2.0 * g.e_star,
                                .poisson_ratio = 0.0,
                                .surface_energy = 0.5 * g.work_of_adhesion};
    std::string deck = fmt::format(
        "# The rig pull_off of similitude in LAMMPS: lmp -in deck.in. SI units.\n{}# Two grains of "
        "radius 2 R*: the upper is led to the next line of way.txt at each step, the lower held.\n",
        release_line(o));
    // A list that holds the pair all the way out, so that no neck is lost where it is made anew. The step has no meaning.
    deck += opening_of_few(start + radius, granular_arguments(contact), 1.0);
    deck +=
        fmt::format(R"(group upper id 2
variable way file way.txt
variable to equal next(way)
fix lead upper move variable NULL NULL v_to NULL NULL NULL
dump rows all custom 1 rows.dump id z fz
dump_modify rows sort id format float %.17g
thermo {}
run {}
)",
                    std::max<std::size_t>(1, way.separation.size() / 20), way.separation.size());
    const double far = 20.0 * radius + 2.0 * start;
    const std::vector<Grain> grains{{{0.0, 0.0, -radius}, {}, {}, radius, 1000.0},
                                    {{0.0, 0.0, radius + start}, {}, {}, radius, 1000.0}};
    return {"deck.in",
            deck,
            {{"start.data", lammps_data(grains, {{-far, -far, -far}, {far, far, far}}, 1)},
             {"way.txt", way_text(way, start)}}};
}

rigs::Curves pull_off_curves(const cases::Case& c, const cases::Experiment& e,
                             const rigs::Ordinates& at, const std::vector<LammpsFrame>& frames) {
    const Way way = way_of(e, at, grain_of(c, e));
    std::vector<double> force(at.at.size(), nothing);
    for (std::size_t k = 0; k < force.size(); ++k) {
        if (way.row_step[k] == 0) continue;
        const auto step = static_cast<std::size_t>(way.row_step[k]);
        if (step >= frames.size() || frames[step].step != way.row_step[k] ||
            frames[step].rows.size() != 2)
            throw std::runtime_error(fmt::format("rows.dump: not two grains at step {}", step));
        force[k] = frames[step].rows[1][frames[step].column("fz")];
    }
    return {{"force", std::move(force)}};
}

std::string tear_off_note(const cases::Case& c, const cases::Experiment& e) {
    const OneGrain g = grain_of(c, e);
    if (!(g.work_of_adhesion > 0.0)) return "";
    const auto gap = [&](contact::TearOff rule) {
        const contact::Jkr jkr{g.e_star, g.work_of_adhesion, rule};
        return -jkr.tear_off_overlap(g.r_star, jkr.length_scale(g.r_star));
    };
    return fmt::format(
        "LAMMPS lets go at the deepest tension, a gap of {:.4g} m; under a rigid drive JKR holds "
        "to its fold, {:.4g} m: rows of the "
        "retraction between have no force",
        gap(contact::TearOff::max_tension), gap(contact::TearOff::fold));
}

}  // namespace engines
