// SPDX-License-Identifier: MIT
// The program LAMMPS: where it is, which release, one run of a deck.
#pragma once

#include <filesystem>
#include <string>

namespace engines {

// Throws scaling::InvalidInput that names the package where `lmp` is not installed. `option` is what asked for it.
std::filesystem::path lammps_program(const std::string& option = "--against");

// "29 Sep 2021 - Update 2", from the first line that it prints; "unknown" where that is another.
std::string lammps_release(const std::string& output);

// The same of the program itself, without a deck.
std::string installed_release(const std::filesystem::path& lmp);

// What to say of results of this release: empty of that which the decks were written for and are checked with.
std::string words_of_release(const std::string& release);

// The error lines of an output, or its last one where there is none.
std::string lammps_complaint(const std::string& output);

// Writes `data` to start.data and `deck` to deck.in in `folder`, made new where it is not there, and
// runs `lmp -in deck.in` in it. Returns what LAMMPS printed. Throws std::runtime_error with its error
// lines, or where it takes longer than limit_s.
std::string run_lammps(const std::filesystem::path& lmp, const std::filesystem::path& folder,
                       const std::string& deck, const std::string& data, double limit_s);

// Throws std::runtime_error naming the file that cannot be read or written.
std::string file_text(const std::filesystem::path&);
void write_text(const std::filesystem::path&, const std::string& text);

}  // namespace engines
