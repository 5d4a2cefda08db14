// SPDX-License-Identifier: MIT
#include "engines/lammps_files.hpp"

#include "engines/lammps_dump.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace engines {
std::string opening_of_few(double skin, const std::string& rules, double time_step) {
    return fmt::format(R"(units si
atom_style sphere
atom_modify map array
boundary f f f
newton off
comm_modify vel yes
read_data start.data
neighbor {:.17g} bin
neigh_modify delay 0 every 1 check yes
pair_style granular
pair_coeff * * {}
timestep {:.17g}
)",
                       skin, rules, time_step);
}

std::string lammps_data(const std::vector<dem_min::Grain>& grains, const Box& box, int types) {
    std::string text =
        fmt::format("written by similitude\n\n{} atoms\n{} atom types\n\n", grains.size(), types);
    text +=
        fmt::format("{:.17g} {:.17g} xlo xhi\n{:.17g} {:.17g} ylo yhi\n{:.17g} {:.17g} zlo zhi\n",
                    box.low.x, box.high.x, box.low.y, box.high.y, box.low.z, box.high.z);
    text += "\nAtoms # sphere\n\n";
    for (std::size_t k = 0; k < grains.size(); ++k) {
        const dem_min::Grain& g = grains[k];
        text +=
            fmt::format("{} {} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", k + 1, g.fixed ? 2 : 1,
                        2.0 * g.radius, g.density, g.position.x, g.position.y, g.position.z);
    }
    text += "\nVelocities\n\n";
    for (std::size_t k = 0; k < grains.size(); ++k) {
        const dem_min::Grain& g = grains[k];
        text += fmt::format("{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", k + 1,
                            g.velocity.x, g.velocity.y, g.velocity.z, g.spin.x, g.spin.y, g.spin.z);
    }
    return text;
}

namespace {

FinalGrains grains_of(const LammpsFrame& f, double density, const std::string& extra) {
    const std::size_t x = f.column("x"), v = f.column("vx"), w = f.column("omegax");
    const std::size_t radius = f.column("radius"), type = f.column("type");
    const auto glued = std::find(f.columns.begin(), f.columns.end(), "v_glued");
    const auto fixed = [&](const std::vector<double>& row) {
        return glued == f.columns.end()
                   ? row[type] == 2.0
                   : row[static_cast<std::size_t>(glued - f.columns.begin())] == 1.0;
    };
    FinalGrains all{f.step, {}, {}};
    for (const std::vector<double>& row : f.rows) {
        all.grains.push_back({{row[x], row[x + 1], row[x + 2]},
                              {row[v], row[v + 1], row[v + 2]},
                              {row[w], row[w + 1], row[w + 2]},
                              row[radius],
                              density,
                              fixed(row)});
        if (!extra.empty()) all.extra.push_back(row[f.column(extra)]);
    }
    return all;
}

}  // namespace

FinalGrains read_final_grains(const std::filesystem::path& folder, double density,
                              const std::string& extra) {
    const std::filesystem::path file = folder / "final.dump";
    const auto frames = read_lammps_frames(file);
    if (frames.size() != 1) throw std::runtime_error(file.string() + ": not one frame");
    return grains_of(frames.front(), density, extra);
}

std::vector<FinalGrains> read_grains(const std::filesystem::path& file, double density) {
    std::vector<FinalGrains> all;
    for (const LammpsFrame& f : read_lammps_frames(file)) all.push_back(grains_of(f, density, ""));
    return all;
}

}  // namespace engines
