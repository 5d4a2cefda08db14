// SPDX-License-Identifier: MIT
#include "engines/bed_engine.hpp"

#include "engines/bed_lammps.hpp"
#include "engines/bed_liggghts.hpp"
#include "engines/bed_yade.hpp"

namespace engines {

const std::vector<BedEngine>& bed_engines() {
    static const std::vector<BedEngine> all = {lammps(), liggghts(), yade()};
    return all;
}

}  // namespace engines
