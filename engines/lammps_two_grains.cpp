// SPDX-License-Identifier: MIT
#include "engines/lammps_two_grains.hpp"

#include "engines/lammps_dump.hpp"
#include "engines/lammps_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace engines {
namespace {

constexpr double time_limit = 120.0;  // s: a few thousand steps of two grains take less than one

// Everything before the motion.
std::string opening(const TwoGrains& t) {
    return opening_of_few(t.skin, granular_arguments(t.contact), t.time_step) +
           R"(thermo 1000000
dump states all custom 1 states.dump id x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz
dump_modify states sort id format float %.17g
)";
}

std::string motion(const dem_min::Grain& g, int id, double sign) {
    return fmt::format("fix lead{} grain{} move linear {:.17g} {:.17g} {:.17g}\n", id, id,
                       sign * g.velocity.x, sign * g.velocity.y, sign * g.velocity.z);
}

Box box_around(const TwoGrains& t) {
    double reach = 0.0;
    for (const dem_min::Grain& g : t.grains)
        reach = std::max(reach, 20.0 * g.radius + contact::norm(g.position) +
                                    contact::norm(g.velocity) * t.time_step *
                                        static_cast<double>(t.steps + t.steps_apart));
    return {{-reach, -reach, -reach}, {reach, reach, reach}};
}

PairStates states_of(const std::vector<LammpsFrame>& frames) {
    PairStates states;
    for (const LammpsFrame& f : frames) {
        if (f.rows.size() != 2) throw std::runtime_error("LAMMPS lost one of two grains");
        std::array<GrainState, 2> pair{};
        for (std::size_t k = 0; k < 2; ++k) {
            const auto triple = [&](const std::string& first) {
                const std::size_t c = f.column(first);
                return dem_min::Vec3{f.rows[k][c], f.rows[k][c + 1], f.rows[k][c + 2]};
            };
            pair[k] = {triple("x"), triple("vx"), triple("omegax"), triple("fx"), triple("tqx")};
        }
        states.push_back(pair);
    }
    return states;
}

}  // namespace

std::string led_deck(const TwoGrains& t) {
    std::string deck = opening(t) + "group grain1 id 1\ngroup grain2 id 2\n";
    deck += motion(t.grains[0], 1, 1.0) + motion(t.grains[1], 2, 1.0);
    deck += fmt::format("run {}\n", t.steps);
    deck += motion(t.grains[0], 1, -1.0) + motion(t.grains[1], 2, -1.0);
    // `pre no` would go on with the old motion; a new start evaluates the forces of the last step
    // once more, without moving any history.
    return deck + fmt::format("run {}\n", t.steps_apart);
}

std::string thrown_deck(const TwoGrains& t) {
    return opening(t) + fmt::format("fix motion all nve/sphere\nrun {}\n", t.steps);
}

std::string thrown_at_wall_deck(const TwoGrains& t) {
    return opening(t) + fmt::format(
                            "fix floor all wall/gran granular {} zplane 0.0 NULL\n"
                            "fix motion all nve/sphere\nrun {}\n",
                            granular_arguments(t.contact), t.steps);
}

PairStates run_two_grains(const std::filesystem::path& lmp, const TwoGrains& t,
                          const std::string& deck, const std::filesystem::path& folder) {
    run_lammps(lmp, folder, deck, lammps_data({t.grains.begin(), t.grains.end()}, box_around(t), 1),
               time_limit);
    std::vector<LammpsFrame> frames = read_lammps_frames(folder / "states.dump");
    // The step at which a second run starts is dumped twice.
    const auto same = [](const LammpsFrame& a, const LammpsFrame& b) { return a.step == b.step; };
    frames.erase(std::unique(frames.begin(), frames.end(), same), frames.end());
    return states_of(frames);
}

}  // namespace engines
