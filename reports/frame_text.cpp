// SPDX-License-Identifier: MIT
#include "reports/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numbers>
#include <utility>

namespace reports {

namespace {

using contact::Vec3;

// Lines are gathered before they go to the stream: grains come by the million.
class Lines {
  public:
    explicit Lines(std::ostream& out) : out_(out) {}
    ~Lines() { flush(); }
    Lines(const Lines&) = delete;
    Lines& operator=(const Lines&) = delete;

    template <class... Values>
    void add(fmt::format_string<Values...> format, Values&&... values) {
        fmt::format_to(std::back_inserter(gathered_), format, std::forward<Values>(values)...);
        if (gathered_.size() > 1 << 16) flush();
    }

  private:
    void flush() {
        out_.write(gathered_.data(), static_cast<std::streamsize>(gathered_.size()));
        gathered_.clear();
    }
    std::ostream& out_;
    fmt::memory_buffer gathered_;
};

}  // namespace

// Columns and headings: LAMMPS manual, "dump custom" and "dump_modify" (keywords time, units). The
// order units, time, step is the one that read_dump of LAMMPS asks for.
void write_lammps(std::ostream& out, const Frame& f, bool first) {
    Lines lines(out);
    if (first) lines.add("ITEM: UNITS\nsi\n");
    lines.add("ITEM: TIME\n{}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n", f.time, f.step,
              f.count());
    lines.add("ITEM: BOX BOUNDS ff ff ff\n{} {}\n{} {}\n{} {}\n", f.low.x, f.high.x, f.low.y,
              f.high.y, f.low.z, f.high.z);
    lines.add("ITEM: ATOMS id type x y z vx vy vz omegax omegay omegaz radius mass diameter\n");
    for (std::size_t k = 0; k < f.count(); ++k) {
        const Vec3 &x = f.position[k], &v = f.velocity[k], &w = f.spin[k];
        lines.add("{} {} {} {} {} {} {} {} {} {} {} {} {} {}\n", f.id[k], f.type_of(k), x.x, x.y,
                  x.z, v.x, v.y, v.z, w.x, w.y, w.z, f.radius[k], f.mass[k], 2.0 * f.radius[k]);
    }
}

// Layout: LAMMPS manual, "read_data", for atom_style sphere. Its first line is a comment, in which releases from 2023 on look for units.
void write_lammps_data(std::ostream& out, const Frame& f) {
    Lines lines(out);
    int types = 1;
    for (std::size_t k = 0; k < f.count(); ++k) types = std::max(types, f.type_of(k));
    lines.add("LAMMPS data file written by similitude, timestep = {}, units = si\n\n", f.step);
    lines.add("{} atoms\n{} atom types\n\n", f.count(), types);
    lines.add("{} {} xlo xhi\n{} {} ylo yhi\n{} {} zlo zhi\n\nAtoms # sphere\n\n", f.low.x,
              f.high.x, f.low.y, f.high.y, f.low.z, f.high.z);
    for (std::size_t k = 0; k < f.count(); ++k) {
        const Vec3& x = f.position[k];
        const double r = f.radius[k];
        lines.add("{} {} {} {} {} {} {}\n", f.id[k], f.type_of(k), 2.0 * r,
                  f.mass[k] / (4.0 / 3.0 * std::numbers::pi * (r * r * r)), x.x, x.y, x.z);
    }
    lines.add("\nVelocities\n\n");
    for (std::size_t k = 0; k < f.count(); ++k) {
        const Vec3 &v = f.velocity[k], &w = f.spin[k];
        lines.add("{} {} {} {} {} {} {}\n", f.id[k], v.x, v.y, v.z, w.x, w.y, w.z);
    }
}

void write_yade_text(std::ostream& out, const Frame& f) {
    Lines lines(out);
    lines.add("#format x_y_z_r\n");
    for (std::size_t k = 0; k < f.count(); ++k)
        lines.add("{} {} {} {}\n", f.position[k].x, f.position[k].y, f.position[k].z, f.radius[k]);
}

// Grammar: github.com/libAtoms/extxyz and OVITO's manual, "XYZ file reader"; `velo` and `radius` are
// names that OVITO knows. Without `Origin`, which ASE passes over, the cell would start at 0.
void write_extxyz(std::ostream& out, const Frame& f) {
    Lines lines(out);
    const Vec3 edge = f.high - f.low;
    lines.add("{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"F F F\" ", f.count(),
              edge.x, edge.y, edge.z, f.low.x, f.low.y, f.low.z);
    lines.add(
        "Properties=species:S:1:pos:R:3:id:I:1:radius:R:1:velo:R:3:spin:R:3:mass:R:1:fixed:I:1 "
        "Time={} Step={} units=\"m kg s rad\"\n",
        f.time, f.step);
    for (std::size_t k = 0; k < f.count(); ++k) {
        const Vec3 &x = f.position[k], &v = f.velocity[k], &w = f.spin[k];
        lines.add("X {} {} {} {} {} {} {} {} {} {} {} {} {}\n", x.x, x.y, x.z, f.id[k], f.radius[k],
                  v.x, v.y, v.z, w.x, w.y, w.z, f.mass[k], f.fixed[k] ? 1 : 0);
    }
}

}  // namespace reports
