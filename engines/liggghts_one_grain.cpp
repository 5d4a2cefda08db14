// SPDX-License-Identifier: MIT
#include "engines/lammps_one_grain.hpp"
#include "engines/liggghts_contact.hpp"
#include "engines/liggghts_decks.hpp"

#include <fmt/format.h>

namespace engines {

std::string liggghts_opening(const LiggghtsRules& rules) {
    return fmt::format(R"(units si
atom_style granular
# A sort of the grains at the start of a run would renumber what the springs of contacts belong to.
atom_modify map array sort 0 0.0
boundary f f f
newton off
communicate single vel yes
{})",
                       rules.moduli);
}

std::string liggghts_model(const LiggghtsRules& rules, double skin, double time_step) {
    std::string text = fmt::format("neighbor {:.17g} bin\n", skin);
    for (const std::string& line : rules.properties) text += line + "\n";
    return text + fmt::format("pair_style gran {}\npair_coeff * *\ntimestep {:.17g}\n", rules.model,
                              time_step);
}

Deck liggghts_one_grain(const cases::Case& c, const cases::Experiment& e, const rigs::Ordinates& at,
                        const DeckOptions& options) {
    const Throw t(c, e, at, options, "liggghts");
    const rigs::ContactParameters contact = t.contact();
    refuse_liggghts_restitution(contact.restitution, options);
    const LiggghtsRules rules = liggghts_rules(contact, contact, 2.0 * t.radius());
    std::string deck = fmt::format(
        "# The rig {} of similitude in LIGGGHTS-PUBLIC 3.8.0: liggghts -in deck.in. SI units; the "
        "plate is z = 0.\n",
        t.rig());
    deck += liggghts_opening(rules) + "read_data start.data\n";
    deck += liggghts_model(rules, t.radius(), t.time_step());
    deck += fmt::format(
        "neigh_modify delay 0 every 1 check yes\n"
        "fix plate all wall/gran {} primitive type 3 zplane 0.0\nfix motion all nve/sphere\n",
        rules.model);
    // LIGGGHTS takes the forms of all columns, not that of the numbers alone.
    std::string format = "format \"%d";
    for (int k = 0; k < 9; ++k) format += " %.17g";
    Deck result{"deck.in", deck + lammps_like_run(t, format + "\"")};
    result.files.emplace_back("start.data", liggghts_data(t.grains(), t.box(), 1, 1));
    if (t.over_time()) result.files.emplace_back("rows.txt", rows_text(t));
    return result;
}

}  // namespace engines
