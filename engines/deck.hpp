// SPDX-License-Identifier: MIT
// A deck for another engine: the input that it runs, and the files beside it.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace engines {

struct Deck {
    std::string name;                                          // "deck.in"
    std::string deck;                                          // its text
    std::vector<std::pair<std::string, std::string>> files{};  // name and text, beside it
};

// Results, logs and batches of an earlier run in the folder go: none of them may be taken for this run's.
void write_deck(const Deck&, const std::filesystem::path& folder);

// The syntax of LAMMPS: of the release that decks are run with, or of the manual's later ones (engines/lammps_rules.hpp).
enum class LammpsRelease { of_2021, later };

// How a deck is asked for.
struct DeckOptions {
    std::string option = "--engine";  // that a refusal names
    bool nearest = false;  // where the engine has not the case's law, the nearest that it has
    LammpsRelease lammps = LammpsRelease::of_2021;
};

// Throws scaling::InvalidInput: `engine` cannot what `what` says.
[[noreturn]] void refuse(const DeckOptions&, const std::string& engine, const std::string& what,
                         const std::string& remedy);

}  // namespace engines
