// SPDX-License-Identifier: MIT
// The engines that run a rig of ours as a deck: how each is named, started and understood (docs/export.md).
#pragma once

#include "cases/case.hpp"
#include "engines/deck.hpp"
#include "rigs/flow.hpp"
#include "rigs/forward.hpp"
#include "rigs/pile.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace engines {

struct Peer {
    std::string name;     // as --engine takes it: "lammps"
    std::string title;    // in a sentence: "LAMMPS"
    std::string program;  // "lmp"
    std::string package;  // of Debian
    std::string log;      // file in the deck's folder that tells what went wrong
    bool ranks;           // runs under MPI
    bool jkr;             // has it, and so a deck for the rig pull_off
    // All throw scaling::InvalidInput for what the engine has not or is not told of.
    Deck (*pile)(const rigs::PileSetup&, const DeckOptions&);
    Deck (*one_grain)(const cases::Case&, const cases::Experiment&, const rigs::Ordinates&,
                      const DeckOptions&);
    // Of the rigs discharge, column and drum; null where it has no decks for these.
    Deck (*flow)(const rigs::FlowSetup&, const DeckOptions&);
    // Two grains drawn apart in the nearest law (engines/nearest.hpp); null where none is needed.
    Deck (*apart)(const rigs::PileSetup&);
    std::vector<std::string> (*command)(const std::string& program, int ranks);
    std::string (*release)(const std::string& output);  // "unknown" where it does not say
    std::string (*words_of_release)(
        const std::string&);  // of one that decks are unchecked with; may be null
    std::string (*complaint)(const std::string& output);
};

// lammps, liggghts, yade.
const std::vector<Peer>& peers();

// Whether the experiment is of a rig that the engine has a deck for.
bool has_deck(const Peer&, const cases::Experiment&);

// Null where there is none of that name.
const Peer* find_peer(const std::string& name);

// As the log in the deck's folder, where the engine writes none of its own.
void keep_output(const Peer&, const std::filesystem::path& folder, const std::string& output);

// Throws scaling::InvalidInput that names the package where it is not installed.
std::filesystem::path program_of(const Peer&, const std::string& option = "--engine");

}  // namespace engines
