// SPDX-License-Identifier: MIT
// An engine as the bed sees it: where it is, which files it wants, how it is started, what it said.
#pragma once

#include "engines/bed.hpp"

#include <functional>
#include <string>
#include <vector>

namespace engines {

struct DeckFile {
    std::string name, text;
};

struct BedEngine {
    std::string name;     // as on the command line: "lammps"
    std::string title;    // as in a table: "LAMMPS"
    std::string program;  // "lmp"
    std::string package;  // of Debian
    std::string laws;     // what it runs on the bed
    std::string differs;  // from our laws and our bed, in a sentence; empty where it does not
    std::function<std::vector<DeckFile>(const Bed&)> deck;
    std::function<std::vector<std::string>(int threads)>
        command;  // run beside the files of the deck
    // Throws std::runtime_error that quotes the end of the output where the figures are not in it.
    std::function<BedFigures(const Bed&, const std::string& output)> read;
};

// lammps, liggghts, yade.
const std::vector<BedEngine>& bed_engines();

}  // namespace engines
