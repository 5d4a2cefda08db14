// SPDX-License-Identifier: MIT
#include "engines/lammps_slump.hpp"

#include "engines/lammps_run.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace engines {

// `freeze` is what makes a glued grain count as infinitely heavy in m*; pairs of glued grains are
// taken out of the list.
std::string slump_deck(const Slump& s) {
    return fmt::format(R"(units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
read_data start.data
group loose type 1
group base type 2
neighbor {:.17g} bin
neigh_modify delay 0 every 1 check yes exclude group base base
pair_style granular
pair_coeff * * {}
timestep {:.17g}
fix fall loose gravity {:.17g} vector 0 0 -1
fix hold base freeze
fix motion loose nve/sphere
thermo 10000
thermo_modify lost ignore
run {}
write_dump all custom final.dump id type x y z vx vy vz omegax omegay omegaz radius modify sort id format float %.17g
)",
                       s.skin, granular_arguments(s.contact), s.time_step, s.gravity, s.steps);
}

std::string slump_data(const Slump& s) { return lammps_data(s.grains, s.box, 2); }

std::vector<dem_min::Grain> run_slump(const std::filesystem::path& lmp, const Slump& s,
                                      const std::filesystem::path& folder, double limit_s) {
    run_lammps(lmp, folder, slump_deck(s), slump_data(s), limit_s);
    return read_final_grains(folder, s.grains.front().density).grains;
}

}  // namespace engines
