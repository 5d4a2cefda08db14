// SPDX-License-Identifier: MIT
#include "engines/lammps_one_grain.hpp"

#include "engines/lammps_files.hpp"
#include "engines/lammps_pull_off.hpp"
#include "engines/lammps_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace engines {

std::string lammps_like_run(const Throw& t, const std::string& format) {
    std::string deck;
    if (t.gravity() > 0.0)
        deck += fmt::format("fix gravity all gravity {:.17g} vector {:.17g} 0 {:.17g}\n",
                            t.gravity(), std::sin(t.angle()), -std::cos(t.angle()));
    deck += "dump rows all custom 1 rows.dump id x y z vx vy vz omegax omegay omegaz\n";
    if (t.over_time())
        deck +=
            "variable row file rows.txt\nvariable due equal next(row)\n"
            "dump_modify rows every v_due sort id first no ";
    else
        deck += fmt::format("dump_modify rows every {} sort id ", t.steps());
    return deck + fmt::format("{}\nthermo {}\nrun {}\n", format,
                              std::max<std::int64_t>(1, t.steps() / 20), t.steps());
}

std::string rows_text(const Throw& t) {
    std::string text;
    for (const std::int64_t step : t.row_steps()) text += fmt::format("{}\n", step);
    // LAMMPS reads one ahead of the last.
    return text + fmt::format("{}\n", t.steps() + 1000000000);
}

double lammps_time_step(const cases::Case& c, const cases::Experiment& e) {
    return Throw(c, e, rigs::ordinates_of(e), {}, "lammps").time_step();
}

Deck lammps_one_grain(const cases::Case& c, const cases::Experiment& e, const rigs::Ordinates& at,
                      const DeckOptions& options) {
    if (e.rig == "pull_off") return lammps_pull_off(c, e, at, options);
    const Throw t(c, e, at, options, "lammps");
    const rigs::ContactParameters contact = t.contact();
    refuse_restitution(contact.restitution, options);
    // Nothing adheres here: no dashpot is fitted to a pair.
    const std::string rules = granular_arguments(contact, options, {});
    std::string deck = fmt::format(
        "# The rig {} of similitude in LAMMPS: lmp -in deck.in. SI units; the plate is z = 0.\n{}"
        "# One run: in the release of 2021 the dashpot of a wall changes with every further one.\n",
        t.rig(), release_line(options));
    deck += opening_of_few(t.radius(), rules, t.time_step());
    deck += fmt::format(
        "fix plate all wall/gran granular {} zplane 0.0 NULL\nfix motion all nve/sphere\n", rules);
    Deck result{"deck.in", deck + lammps_like_run(t, "format float %.17g")};
    result.files.emplace_back("start.data", lammps_data(t.grains(), t.box(), 1));
    if (t.over_time()) result.files.emplace_back("rows.txt", rows_text(t));
    return result;
}

}  // namespace engines
