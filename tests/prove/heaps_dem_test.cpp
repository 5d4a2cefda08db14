// SPDX-License-Identifier: MIT
// The truth of blind heaps beside our own core, where both have the same physics: two codes that share nothing.
#include "cases/read_case.hpp"
#include "prove/heap_case.hpp"
#include "rigs/pile.hpp"
#include "rigs/scanner.hpp"
#include "statistics/equivalence.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace prove;

namespace {

namespace fs = std::filesystem;

constexpr std::size_t heaps = 10;

// Of each heap, [heaps].
struct Seen {
    std::vector<double> grains, height;  // that stay; mean of the scan over d
};

std::vector<double> scanned_mean(const std::vector<double>& z, double d, std::vector<double> all) {
    double sum = 0.0;
    for (const double v : z) sum += v;
    all.push_back(sum / static_cast<double>(z.size()) / d);
    return all;
}

Seen by_lammps(const Arrangement& a, const HeapPhysics& acts, const fs::path& folder) {
    Seen seen;
    for (std::size_t k = 0; k < heaps; ++k) {
        for (const auto& [name, text] : lammps_files({a.grain, a.rig, acts, 100 + k}))
            std::ofstream(folder / name) << text;
        const std::string where = folder.string();
        REQUIRE(std::system(("lmp -in " + where + "/deck.in -var folder " + where + " -log " +
                             where + "/log -screen none")
                                .c_str()) == 0);
        std::ifstream in(folder / "heap.dump");
        const std::vector<Ball> heap = read_heap({std::istreambuf_iterator<char>(in), {}});
        std::vector<double> z;
        for (const Spot& spot : a.spots) z.push_back(height_above(heap, spot));
        seen.grains.push_back(static_cast<double>(heap.size()));
        seen.height = scanned_mean(z, a.grain.diameter, std::move(seen.height));
    }
    return seen;
}

Seen by_core(const Arrangement& a, const cases::Case& c) {
    std::vector<double> azimuth, r;
    for (const Spot& spot : a.spots) azimuth.push_back(spot.azimuth), r.push_back(spot.r);
    Seen seen;
    for (std::uint64_t seed = 1; seed <= heaps; ++seed) {
        const rigs::PileSetup setup = rigs::pile_setup(c, c.experiments.front(), seed);
        rigs::PileRun run = rigs::begin_pile(setup, 1);
        while (!run.finished) rigs::advance(run, setup, 100'000);
        const rigs::Heap heap = rigs::record(run, setup).heap;
        seen.grains.push_back(static_cast<double>(heap.centre.size()));
        seen.height = scanned_mean(rigs::heights_at(heap, azimuth, r), a.grain.diameter,
                                   std::move(seen.height));
    }
    return seen;
}

}  // namespace

// Heaps scatter by some 4 % in either: the interval of ten beside ten is +-4 % wide. Grains fed into others took a fifth off a heap, a
// dashpot that was told 0.5 and had 0.62 a tenth: the margin lies between.
TEST_CASE("heaps: LAMMPS' truth and our core pour the same where the physics is the same",
          "[prove][heaps][dem]") {
    const HeapFamily f = heap_family(3, 1, 0.3);
    const Arrangement& a = f.arrangements.front();
    HeapPlan plan = heap_plan(3, 1, f);
    plan.start = plan.friction = 0.5;
    const fs::path folder = fs::temp_directory_path() / "similitude-heaps-both";
    fs::remove_all(folder);
    const auto recordings = heap_recordings(3, plan, f);
    BlindCase made;
    made.files = heap_files(
        plan, f, recordings,
        std::vector<std::vector<double>>(recordings.size(), std::vector<double>(192, 1e-3)));
    made.key.name = "both", made.key_text = "{}";
    write(made, folder / "cases", folder / "keys");
    const cases::Case c = cases::read_case((folder / "cases" / "both" / "case.json").string());
    const Seen core = by_core(a, c), truth = by_lammps(a, with_effect(f, "", 0.0, 0.5), folder);
    for (const auto& [ours, theirs] :
         {std::pair{&core.grains, &truth.grains}, std::pair{&core.height, &truth.height}}) {
        const statistics::Summary mean = statistics::summary(*ours);
        const statistics::Equivalence e =
            statistics::two_one_sided_tests(mean, statistics::summary(*theirs), 0.1 * mean.mean);
        INFO("difference " << e.difference / mean.mean << " [" << e.interval.low / mean.mean << ", "
                           << e.interval.high / mean.mean << "] of " << mean.mean);
        CHECK(e.equivalent);
    }
    fs::remove_all(folder);
}
