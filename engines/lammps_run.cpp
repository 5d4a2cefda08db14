// SPDX-License-Identifier: MIT
#include "engines/lammps_run.hpp"

#include "engines/peer.hpp"
#include "engines/process.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace engines {
namespace {
constexpr double help_limit = 60.0;  // s
}

std::string lammps_complaint(const std::string& output) {
    std::istringstream in(output);
    std::string all, last;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("ERROR")) all += (all.empty() ? "" : "; ") + line;
        if (!line.empty()) last = line;
    }
    return all.empty() ? last : all;
}

std::filesystem::path lammps_program(const std::string& option) {
    return program_of(*find_peer("lammps"), option);
}

std::string lammps_release(const std::string& output) {
    const std::string start = "LAMMPS (";
    const std::size_t end = output.find(')');
    if (!output.starts_with(start) || end == std::string::npos) return "unknown";
    return output.substr(start.size(), end - start.size());
}

std::string installed_release(const std::filesystem::path& lmp) {
    const std::string help = run({lmp.string(), "-h"}, ".", help_limit).out;
    const std::string start = "Simulator - ";
    const std::size_t at = help.find(start);
    if (at == std::string::npos) return "unknown";
    const std::size_t first = at + start.size();
    return help.substr(first, help.find('\n', first) - first);
}

std::string words_of_release(const std::string& release) {
    const std::string known = "29 Sep 2021";
    if (release.starts_with(known)) return "";
    return fmt::format(
        "LAMMPS of {}: the deck was written for that of {}, whose dashpots, torques and tear-off "
        "it "
        "reckons with, and is unchecked with any other.",
        release, known);
}

std::string run_lammps(const std::filesystem::path& lmp, const std::filesystem::path& folder,
                       const std::string& deck, const std::string& data, double limit_s) {
    std::filesystem::create_directories(folder);
    for (const char* earlier : {"final.dump", "states.dump"})
        std::filesystem::remove(folder / earlier);
    write_text(folder / "start.data", data);
    write_text(folder / "deck.in", deck);
    const Finished f = run({lmp.string(), "-in", "deck.in", "-log", "none"}, folder, limit_s);
    if (f.timed_out)
        throw std::runtime_error(
            fmt::format("{}: LAMMPS took longer than {:g} s", folder.string(), limit_s));
    if (f.exit_code != 0)
        throw std::runtime_error(fmt::format("{}: LAMMPS ended with {}: {}", folder.string(),
                                             f.exit_code, lammps_complaint(f.out)));
    return f.out;
}

std::string file_text(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) throw std::runtime_error(file.string() + ": cannot be read");
    return text.str();
}

void write_text(const std::filesystem::path& file, const std::string& text) {
    std::ofstream out(file);
    out << text;
    if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace engines
