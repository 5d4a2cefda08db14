// SPDX-License-Identifier: MIT
#include "engines/deck.hpp"

#include "engines/lammps_run.hpp"
#include "engines/peer.hpp"
#include "scaling/errors.hpp"

namespace engines {

void write_deck(const Deck& d, const std::filesystem::path& folder) {
    std::filesystem::remove_all(folder / "feed");  // batches of a longer feed
    for (const char* result : {"final.dump", "final.data", "rows.dump", "looks.dump"})
        std::filesystem::remove(folder / result);
    for (const Peer& peer : peers()) std::filesystem::remove(folder / peer.log);
    std::filesystem::create_directories(folder);
    write_text(folder / d.name, d.deck);
    for (const auto& [name, text] : d.files) {
        std::filesystem::create_directories((folder / name).parent_path());
        write_text(folder / name, text);
    }
}

void refuse(const DeckOptions& o, const std::string& engine, const std::string& what,
            const std::string& remedy) {
    throw scaling::InvalidInput(scaling::mistake(o.option, engine, what, remedy));
}

}  // namespace engines
