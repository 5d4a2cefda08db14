// SPDX-License-Identifier: MIT
#include "app/poured_heaps.hpp"

#include "cases/read_case.hpp"
#include "command_line.hpp"
#include "diagnose/diagnose.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace {

// Three soft grains on a plate.
rigs::PileSetup few(std::uint64_t seed) {
    const cases::Case c = cases::read_case("data/zirconia/heap-50mm.json");
    rigs::PileSetup s = rigs::pile_setup(c, c.experiments.at(0), seed);
    s.conditions.grains = 3;
    for (rigs::ContactParameters* laws : {&s.grains, &s.walls})
        laws->e_star *= 1e-3, laws->g_star *= 1e-3, laws->work_of_adhesion = 0.0;
    rigs::choose_feed(s, c.grain, seed);
    rigs::choose_steps(s);
    return s;
}

bool same(const rigs::Heap& a, const rigs::Heap& b) { return app::to_text(a) == app::to_text(b); }

}  // namespace

TEST_CASE("heaps are poured once, and found again by what they are", "[app][poured_heaps]") {
    const Folder folder;
    const std::vector<rigs::PileSetup> setups{few(1), few(2)};
    std::size_t told = 0;
    const auto show = [&](std::size_t done, std::size_t) { return told = done, true; };
    app::PouredHeaps first(folder / "heaps", 2, show);
    const std::vector<rigs::Heap> heaps = first(setups);
    REQUIRE(heaps.size() == 2);
    CHECK(first.poured() == 2);
    CHECK(told == 2);
    CHECK_FALSE(same(heaps[0], heaps[1]));
    app::PouredHeaps again(folder / "heaps", 1, show);
    const std::vector<rigs::Heap> known = again({setups[1], setups[0]});
    CHECK(again.poured() == 0);
    CHECK(again.recalled() == 2);
    CHECK(same(known[0], heaps[1]));
    CHECK(same(known[1], heaps[0]));
    // One cut off while it was written is poured anew, the same to the last bit.
    for (const auto& file : std::filesystem::directory_iterator(folder / "heaps"))
        std::filesystem::resize_file(file.path(), 40);
    app::PouredHeaps third(folder / "heaps", 1, show);
    CHECK(same(third(setups)[0], heaps[0]));
    CHECK(third.poured() == 2);
}

TEST_CASE("whoever stops is told so, and finished heaps stay", "[app][poured_heaps]") {
    const Folder folder;
    app::PouredHeaps stopped(folder / "heaps", 1,
                             [](std::size_t done, std::size_t) { return done < 1; });
    CHECK_THROWS_AS(stopped({few(1), few(2)}), diagnose::Interrupted);
    app::PouredHeaps on(folder / "heaps", 1, [](std::size_t, std::size_t) { return true; });
    on({few(1), few(2)});
    CHECK(on.recalled() == 1);
    CHECK(on.poured() == 1);
}

TEST_CASE("a heap as text that is not whole is refused", "[app][poured_heaps]") {
    const rigs::Heap heap{.centre = {{1.0, 2.0, 1.0 / 3.0}}, .radius = {0.1}, .base_radius = 3.0};
    const std::string text = app::to_text(heap);
    CHECK(same(app::heap_of(text), heap));
    CHECK_THROWS_AS(app::heap_of(text.substr(0, text.size() - 4)), std::runtime_error);
    CHECK_THROWS_AS(app::heap_of(""), std::runtime_error);
}
