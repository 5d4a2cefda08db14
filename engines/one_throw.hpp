// SPDX-License-Identifier: MIT
// The rigs `drop`, `incline` and `impact` for other engines: one grain, or one for each angle, over the wall z = 0. What all decks
// need of them, and the channels from the rows that a deck writes in the form of LAMMPS' dumps, rows.dump, columns
// `id x y z vx vy vz omegax omegay omegaz`: of a drop or an incline at the step before each row, of an impact at the end.
#pragma once

#include "engines/lammps_dump.hpp"
#include "engines/lammps_files.hpp"
#include "engines/peer.hpp"
#include "rigs/one_grain.hpp"
#include "rigs/physics.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace engines {

class Throw {
  public:
    // Throws scaling::InvalidInput for another rig, for physics beyond gravity, buoyancy and hertz_mindlin, for Euler steps, and for a
    // grain that does not meet the plate. `engine` as a refusal names it.
    Throw(const cases::Case&, const cases::Experiment&, const rigs::Ordinates&, const DeckOptions&,
          const std::string& engine);

    const std::string& rig() const { return experiment_.rig; }
    bool over_time() const { return rig() != "impact"; }
    double radius() const { return grain_.radius; }    // m
    double gravity() const { return grain_.gravity; }  // m/s^2
    double angle() const;                       // of the plane, rad; gravity along (sin, 0, -cos)
    double time_step() const { return step_; }  // s
    rigs::ContactParameters contact() const;    // of grain and plate
    std::vector<dem_min::Grain> grains() const;
    std::int64_t steps() const;                   // of the whole run
    std::vector<std::int64_t> row_steps() const;  // after 0, each once, rising; none of an impact
    Box box() const;

    // Throws std::runtime_error where a grain is missing.
    rigs::Curves curves(const std::vector<LammpsFrame>&) const;

  private:
    double condition(const char* name, double otherwise) const;
    double depth_at_rest() const;
    double fastest() const;
    std::vector<std::int64_t> steps_before_rows() const;
    rigs::Curves of_rows(const std::vector<LammpsFrame>&) const;
    rigs::Curves of_impacts(const LammpsFrame&) const;

    cases::Experiment experiment_;
    rigs::Ordinates at_;
    rigs::Stated stated_;
    rigs::World world_;
    rigs::OneGrain grain_;
    double step_;
};

// Whether the rig is one of these three.
bool is_thrown(const cases::Experiment&);

struct PeerCurvesRun {
    std::string release;
    bool interrupted;  // by a signal to us
    double seconds;    // wall time
    std::vector<std::string> command;
    std::string deck;     // its name in the folder
    rigs::Curves curves;  // the rig's channels, [ordinates]; none where interrupted
    std::string note{};   // where the engine's physics is not the rig's
};

// Of these rigs, and of `pull_off` where the engine has it. Writes the deck into `folder` and runs it there on one rank. Throws std::runtime_error with the engine's error where it fails.
PeerCurvesRun run_one_grain(const Peer&, const std::filesystem::path& program, const cases::Case&,
                            const cases::Experiment&, const rigs::Ordinates&,
                            const std::filesystem::path& folder);

}  // namespace engines
