// SPDX-License-Identifier: MIT
// The rigs `drop`, `incline`, `impact` and, by lammps_pull_off.hpp, `pull_off` in LAMMPS (docs/export.md). One run of a deck, so that the wall damps as it is told to.
// Written for the release of 29 September 2021.
#pragma once

#include "cases/case.hpp"
#include "engines/deck.hpp"
#include "engines/one_throw.hpp"
#include "rigs/forward.hpp"

#include <string>

namespace engines {

// deck.in, start.data and, for a drop or an incline, the steps at which the grain is written, rows.txt. Throws as Throw does, and
// for a restitution below 0.12.
Deck lammps_one_grain(const cases::Case&, const cases::Experiment&, const rigs::Ordinates&,
                      const DeckOptions& = {});

// The step of that deck, s: model.numerics.time_step, or its own choice.
double lammps_time_step(const cases::Case&, const cases::Experiment&);

// What LAMMPS and LIGGGHTS have in common: gravity, the rows and the run; and rows.txt. `format` is what dump_modify calls for so that
// a number is written whole.
std::string lammps_like_run(const Throw&, const std::string& format);
std::string rows_text(const Throw&);

}  // namespace engines
