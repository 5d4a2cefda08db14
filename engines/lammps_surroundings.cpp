// SPDX-License-Identifier: MIT
#include "engines/lammps_surroundings.hpp"

#include <fmt/format.h>

#include <numbers>

namespace engines {
namespace {

using contact::Vec3;
using rigs::PileSetup;

bool leans(const PileSetup& s) { return s.stand.tilt_angle != 0.0; }
Vec3 up(const PileSetup& s) { return -rigs::down(s.stand); }

// Height and speed of the base, m and m/s, at the step that is asked.
std::string swaying(const PileSetup& s) {
    const dem_min::Shaking& base = s.stand.shaking;
    if (!base.acts()) return "variable sway_speed equal 0\n";
    return fmt::format(R"(# The base shakes; all is told in its frame.
variable sway equal {a:.17g}*sin({w:.17g}*step*dt+{phase:.17g})
variable sway_speed equal {a:.17g}*{w:.17g}*cos({w:.17g}*step*dt+{phase:.17g})
variable inertia equal {w:.17g}*{w:.17g}*v_sway
fix shake loose gravity v_inertia vector 0 0 1
)",
                       fmt::arg("a", base.amplitude), fmt::arg("w", base.omega),
                       fmt::arg("phase", base.phase));
}

// Velocities are half a step old: first order in the step, which is short against the time in which drag acts.
std::string drag(const PileSetup& s) {
    const contact::DragSchiller1935& law = s.fluid.drag;
    const double newton = law.factor * 0.44 * std::numbers::pi / 2.0 * law.density;
    const std::string fast = fmt::format("{:.17g}*c_radius*c_radius*v_air_speed", newton);
    std::string all = fast;
    std::string reynolds;
    if (law.viscosity > 0.0) {
        reynolds = fmt::format("variable air_re atom {:.17g}*c_radius*v_air_speed\n",
                               2.0 * law.density / law.viscosity);
        all = fmt::format(
            "(v_air_re<1000)*{:.17g}*c_radius*(1+0.15*v_air_re^0.687)+(v_air_re>=1000)*{}",
            law.factor * 6.0 * std::numbers::pi * law.viscosity, fast);
    }
    return fmt::format(
        R"(# Drag of a fluid at rest in the room, Schiller and Naumann's curve, 0.44 above Re = 1000.
variable air_speed atom sqrt(vx*vx+vy*vy+(vz+v_sway_speed)*(vz+v_sway_speed))
{}variable air_r atom {}
variable drag_x atom -v_air_r*vx
variable drag_y atom -v_air_r*vy
variable drag_z atom -v_air_r*(vz+v_sway_speed)
fix drag loose addforce v_drag_x v_drag_y v_drag_z
)",
        reynolds, all);
}

// The velocity of a fall along plumb, v_fall its z component in the frame.
std::string falling(const PileSetup& s) {
    if (!leans(s)) return "velocity fresh set NULL NULL v_fall units box\n";
    const Vec3 n = up(s);
    return fmt::format(R"(variable fall_x atom (v_fall+v_sway_speed)*{:.17g}
variable fall_y atom (v_fall+v_sway_speed)*{:.17g}
velocity fresh set v_fall_x v_fall_y v_fall units box
)",
                       n.x / n.z, n.y / n.z);
}

}  // namespace

std::string lammps_forces_from_afar(const PileSetup& s) {
    const double g = s.gravity * (1.0 - s.fluid.lifting_density / s.density);
    const Vec3 down = rigs::down(s.stand);
    const std::string where =
        leans(s) ? fmt::format("{:.17g} {:.17g} {:.17g}", down.x, down.y, down.z) : "0 0 -1";
    std::string text = fmt::format("fix fall loose gravity {:.17g} vector {}\n", g, where);
    const bool drags = s.fluid.drag.factor > 0.0;
    if (s.stand.shaking.acts() || drags || leans(s)) text += swaying(s);
    return drags ? text + drag(s) : text;
}

std::string lammps_height(const PileSetup& s) {
    const std::string z = s.stand.shaking.acts() ? "(z+v_sway)" : "z";
    if (!leans(s)) return z;
    const Vec3 n = up(s);
    return fmt::format("(x*{:.17g}+y*{:.17g}+{}*{:.17g})", n.x, n.y, z, n.z);
}

std::string lammps_pushed(const PileSetup& s) {
    if (!leans(s)) return "(fx*fx+fy*fy)>0";
    const Vec3 n = up(s);
    const std::string fz = s.stand.shaking.acts() ? "(fz-mass*v_inertia)" : "fz";
    // 1e-9: squares are rounded; 3e-5 of the weight.
    return fmt::format(
        "(fx*fx+fy*fy+{z}*{z}-(fx*{:.17g}+fy*{:.17g}+{z}*{:.17g})^2)>"
        "1e-9*(mass*{:.17g})^2",
        n.x, n.y, n.z, s.gravity, fmt::arg("z", fz));
}

std::string lammps_reading(const PileSetup& s) {
    std::string shift = "0 0 ${up}", lifted;
    if (leans(s)) {
        const Vec3 n = up(s);
        shift = "${lift_x} ${lift_y} ${lift_z}";
        lifted = fmt::format(R"(variable lift_x equal ${{up}}*{:.17g}
variable lift_y equal ${{up}}*{:.17g}
variable lift_z equal ${{up}}*{:.17g}
)",
                             n.x, n.y, n.z);
    }
    return fmt::format(R"(group fresh clear
{}read_data feed/${{batch}}.data add append shift {} group fresh
group loose type 1
{})",
                       lifted, shift, falling(s));
}

std::string lammps_unparking(const PileSetup& s, double lift) {
    if (!leans(s))
        return fmt::format("variable there atom z-{:.17g}+${{up}}\nset group fresh z v_there\n{}",
                           lift, falling(s));
    const Vec3 n = up(s);
    return fmt::format(R"(variable there_x atom x+(${{up}}-{lift:.17g})*{:.17g}
variable there_y atom y+(${{up}}-{lift:.17g})*{:.17g}
variable there_z atom z+(${{up}}-{lift:.17g})*{:.17g}
set group fresh x v_there_x y v_there_y z v_there_z
{})",
                       n.x, n.y, n.z, falling(s), fmt::arg("lift", lift));
}

}  // namespace engines
