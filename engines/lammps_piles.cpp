// SPDX-License-Identifier: MIT
#include "engines/lammps_piles.hpp"

#include "engines/lammps_pile.hpp"
#include "engines/lammps_run.hpp"
#include "engines/pile_run.hpp"

#include <fmt/format.h>

#include <utility>

namespace engines {

LammpsPiles::LammpsPiles(std::filesystem::path folder, int ranks)
    : lmp_(lammps_program("--engine")),
      folder_(std::move(folder)),
      ranks_(ranks),
      release_(installed_release(lmp_)) {
    refuse_ranks_without_mpirun(ranks);
}

std::string LammpsPiles::name() const {
    return fmt::format("LAMMPS {}, {} rank{}", release_, ranks_, ranks_ == 1 ? "" : "s");
}

std::string LammpsPiles::key(const rigs::PileSetup& s) const {
    const Deck deck = lammps_pile(s);
    std::string text = name() + '\n' + deck.deck;
    for (const auto& [file, content] : deck.files) text += file + '\n' + content;
    return text;
}

std::optional<rigs::PileEnd> LammpsPiles::run(const rigs::PileSetup& s,
                                              const std::function<void(std::int64_t)>& show) {
    write_deck(lammps_pile(s), folder_);
    PeerPileRun done =
        run_pile(*find_peer("lammps"), lmp_, s, folder_, ranks_, [&](const DeckProgress& p) {
            if (show) show(p.step);
        });
    if (done.end) std::filesystem::remove_all(folder_);
    return std::move(done.end);
}

}  // namespace engines
