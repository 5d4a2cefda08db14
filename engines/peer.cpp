// SPDX-License-Identifier: MIT
#include "engines/peer.hpp"

#include "engines/lammps_flow.hpp"
#include "engines/lammps_one_grain.hpp"
#include "engines/lammps_pile.hpp"
#include "engines/lammps_run.hpp"
#include "engines/liggghts_decks.hpp"
#include "engines/nearest.hpp"
#include "engines/one_throw.hpp"
#include "engines/process.hpp"
#include "engines/yade_decks.hpp"
#include "scaling/errors.hpp"

#include <algorithm>

namespace engines {

const std::vector<Peer>& peers() {
    static const std::vector<Peer> all{
        {.name = "lammps",
         .title = "LAMMPS",
         .program = "lmp",
         .package = "lammps",
         .log = "log.lammps",
         .ranks = true,
         .jkr = true,
         .pile = lammps_pile,
         .one_grain = lammps_one_grain,
         .flow = lammps_flow,
         .apart = nullptr,
         .command =
             [](const std::string& program, int ranks) {
                 return lammps_like_deck_command(program, ranks, "log.lammps");
             },
         .release =
             [](const std::string& output) {
                 return lammps_release(
                     output.substr(std::min(output.find("LAMMPS ("), output.size())));
             },
         .words_of_release = words_of_release,
         .complaint = lammps_complaint},
        {.name = "liggghts",
         .title = "LIGGGHTS",
         .program = "liggghts",
         .package = "liggghts",
         .log = "log.liggghts",
         .ranks = true,
         .jkr = false,
         .pile = liggghts_pile,
         .one_grain = liggghts_one_grain,
         .flow = nullptr,
         .apart = liggghts_apart,
         .command =
             [](const std::string& program, int ranks) {
                 return lammps_like_deck_command(program, ranks, "log.liggghts");
             },
         .release = liggghts_release,
         .words_of_release = nullptr,
         .complaint = lammps_complaint},
        {.name = "yade",
         .title = "Yade",
         .program = "yade",
         .package = "yade",
         .log = "log.yade",
         .ranks = false,
         .jkr = false,
         .pile = yade_pile,
         .one_grain = yade_one_grain,
         .flow = nullptr,
         .apart = yade_apart,
         .command = yade_command,
         .release = yade_release,
         .words_of_release = nullptr,
         .complaint = yade_complaint}};
    return all;
}

bool has_deck(const Peer& peer, const cases::Experiment& e) {
    return e.rig == "pile" || is_thrown(e) || (peer.flow && rigs::is_flow(e)) ||
           (peer.jkr && e.rig == "pull_off");
}

const Peer* find_peer(const std::string& name) {
    const auto& all = peers();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Peer& p) { return p.name == name; });
    return found == all.end() ? nullptr : &*found;
}

void keep_output(const Peer& peer, const std::filesystem::path& folder, const std::string& output) {
    if (!std::filesystem::exists(folder / peer.log)) write_text(folder / peer.log, output);
}

std::filesystem::path program_of(const Peer& peer, const std::string& option) {
    if (const auto found = find_program(peer.program)) return *found;
    throw scaling::InvalidInput(scaling::mistake(
        option, peer.name, "needs the program " + peer.program, "apt-get install " + peer.package));
}

}  // namespace engines
