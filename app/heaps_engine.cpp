// SPDX-License-Identifier: MIT
#include "app/heaps_engine.hpp"

#include "engines/lammps_piles.hpp"

#include <CLI/CLI.hpp>

namespace app {

void add_heaps_engine(CLI::App& verb, HeapsEngine& o) {
    verb.add_option("--engine", o.engine,
                    "who runs the heaps: dem_min, or lammps (the program lmp)")
        ->type_name("ENGINE")
        ->capture_default_str();
    verb.add_option("--ranks", o.ranks, "MPI ranks of LAMMPS; 1 by default")->type_name("N");
    verb.add_option("--contact", o.contact,
                    "contact rules of the heaps: own, or lammps (those that LAMMPS has too, on "
                    "either engine)")
        ->type_name("RULES")
        ->capture_default_str();
}

EngineChoice choice_of(const HeapsEngine& o) {
    return engine_choice(o.engine, o.ranks, o.contact,
                         {{"dem_min", "lammps"},
                          {"own", "lammps"},
                          "to run many heaps; simulate runs single ones, in other engines, too"});
}

std::unique_ptr<rigs::PileEngine> engine_of(const EngineChoice& choice,
                                            const std::filesystem::path& remembered) {
    if (choice.peer == nullptr) return nullptr;
    return std::make_unique<engines::LammpsPiles>(
        std::filesystem::absolute(remembered / choice.peer->name), choice.ranks);
}

}  // namespace app
