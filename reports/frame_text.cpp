// SPDX-License-Identifier: MIT
#include "reports/frame.hpp"

#include <fmt/format.h>

#include <iterator>
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
        lines.add("{} {} {} {} {} {} {} {} {} {} {} {} {} {}\n", f.id[k], f.fixed[k] ? 2 : 1, x.x,
                  x.y, x.z, v.x, v.y, v.z, w.x, w.y, w.z, f.radius[k], f.mass[k],
                  2.0 * f.radius[k]);
    }
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
