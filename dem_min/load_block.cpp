// SPDX-License-Identifier: MIT
#include "dem_min/forces.hpp"

namespace dem_min {
namespace {

// Where a block of contacts stands in memory. Raw pointers, so that the loop below sees that nothing moves.
struct Slots {
    const double *r_i, *r_j, *r_star, *m_star, *length_scale, *inverse_inertia_i,
        *inverse_inertia_j, *tear_off_overlap;
    double *sx, *sy, *sz, *rx, *ry, *rz, *twist, *previous_radius, *overlap, *nx, *ny, *nz,
        *dashpot;
    double *fx, *fy, *fz, *tix, *tiy, *tiz, *tjx, *tjy, *tjz;
    double *heat_normal, *heat_tangential, *heat_rolling, *stored_tangential, *stored_rolling;
};

Slots slots(Contacts& c, std::size_t first) {
    return {&c.r_i[first],
            &c.r_j[first],
            &c.r_star[first],
            &c.m_star[first],
            &c.length_scale[first],
            &c.inverse_inertia_i[first],
            &c.inverse_inertia_j[first],
            &c.tear_off_overlap[first],
            &c.sx[first],
            &c.sy[first],
            &c.sz[first],
            &c.rx[first],
            &c.ry[first],
            &c.rz[first],
            &c.twist[first],
            &c.previous_radius[first],
            &c.overlap[first],
            &c.nx[first],
            &c.ny[first],
            &c.nz[first],
            &c.dashpot[first],
            &c.fx[first],
            &c.fy[first],
            &c.fz[first],
            &c.tix[first],
            &c.tiy[first],
            &c.tiz[first],
            &c.tjx[first],
            &c.tjy[first],
            &c.tjz[first],
            &c.heat_normal[first],
            &c.heat_tangential[first],
            &c.heat_rolling[first],
            &c.stored_tangential[first],
            &c.stored_rolling[first]};
}

// What resists sliding and rolling, taken out of the loads of a contact with normal `n`.
struct Resistance {
    Vec3 friction;              // N, on j
    Vec3 rolling_i, rolling_j;  // N m
};

inline Resistance resistance(Vec3 force_on_j, Vec3 torque_on_i, Vec3 torque_on_j, Vec3 n,
                             double lever_i, double lever_j) {
    const Vec3 friction = contact::tangential_part(force_on_j, n);
    const Vec3 moment = contact::cross(n, friction);
    return {friction, torque_on_i + lever_i * moment, torque_on_j + lever_j * moment};
}

// Adds what became heat on the way from the last positions to these, at contact k, whose arrays still hold the last step.
// Over that way each load acts for half a step with its old and for half a step with its new value: their mean times the way
// is the work that the motion lost, exactly, and what springs do not keep of it is heat. The laws' own count of a step takes
// the new value for the whole way, an error of first order in the step.
inline void add_heat(const Slots& c, int k, const Motion& m, const Load& load, double dt) {
    const double lever_j_before = m.lever_j > 0.0 ? c.r_j[k] - 0.5 * c.overlap[k] : 0.0;
    const Resistance before = resistance(
        {c.fx[k], c.fy[k], c.fz[k]}, {c.tix[k], c.tiy[k], c.tiz[k]}, {c.tjx[k], c.tjy[k], c.tjz[k]},
        {c.nx[k], c.ny[k], c.nz[k]}, c.r_i[k] - 0.5 * c.overlap[k], lever_j_before);
    const Resistance now =
        resistance(load.force_on_j, load.torque_on_i, load.torque_on_j, m.n, m.lever_i, m.lever_j);
    const double way = 0.5 * dt;
    const double acts =
        m.overlap >= c.tear_off_overlap[k] ? way : 0.0;  // a torn contact loads nobody any more
    c.heat_normal[k] += (way * c.dashpot[k] + acts * load.dashpot) * m.approach_speed;
    c.heat_tangential[k] +=
        c.stored_tangential[k] - load.stored_tangential -
        contact::dot(way * before.friction + acts * now.friction, m.slip_velocity);
    c.heat_rolling[k] += c.stored_rolling[k] - load.stored_rolling -
                         contact::dot(way * before.rolling_i + acts * now.rolling_i, m.spin_i) -
                         contact::dot(way * before.rolling_j + acts * now.rolling_j, m.spin_j);
    c.stored_tangential[k] = load.stored_tangential;
    c.stored_rolling[k] = load.stored_rolling;
    c.dashpot[k] = load.dashpot;
    c.nx[k] = m.n.x, c.ny[k] = m.n.y, c.nz[k] = m.n.z;
}

template <bool with_ledger, class Interaction>
#ifndef __clang__  // refuses the two attributes together
[[gnu::flatten, gnu::target_clones("avx512f", "avx2", "default")]]
#endif
void load_typed(const Interaction law, const Slots c, const MotionBlock& motion, int size, double dt) {
#ifndef __clang__  // does not know it; `omp simd` keeps g++ 12 from making vectors
#pragma GCC ivdep
#endif
    for (int k = 0; k < size; ++k) {
        const ContactConstants constants{c.r_i[k],
                                         c.r_j[k],
                                         c.r_star[k],
                                         c.m_star[k],
                                         c.length_scale[k],
                                         c.inverse_inertia_i[k],
                                         c.inverse_inertia_j[k],
                                         c.tear_off_overlap[k]};
        const History history{{c.sx[k], c.sy[k], c.sz[k]},
                              {c.rx[k], c.ry[k], c.rz[k]},
                              c.twist[k],
                              c.previous_radius[k]};
        const Motion m = motion.get(k);
        const Load load = evaluate(law, constants, m, history, dt);
        if constexpr (with_ledger) add_heat(c, k, m, load, dt);
        c.overlap[k] = m.overlap;
        c.sx[k] = load.history.tangential_spring.x;
        c.sy[k] = load.history.tangential_spring.y;
        c.sz[k] = load.history.tangential_spring.z;
        c.rx[k] = load.history.rolling_spring.x;
        c.ry[k] = load.history.rolling_spring.y;
        c.rz[k] = load.history.rolling_spring.z;
        c.twist[k] = load.history.twist;
        c.previous_radius[k] = load.history.previous_radius;
        c.fx[k] = load.force_on_j.x, c.fy[k] = load.force_on_j.y, c.fz[k] = load.force_on_j.z;
        c.tix[k] = load.torque_on_i.x, c.tiy[k] = load.torque_on_i.y, c.tiz[k] = load.torque_on_i.z;
        c.tjx[k] = load.torque_on_j.x, c.tjy[k] = load.torque_on_j.y, c.tjz[k] = load.torque_on_j.z;
    }
}

}  // namespace

void MotionBlock::set(int k, const Motion& m) {
    nx[k] = m.n.x, ny[k] = m.n.y, nz[k] = m.n.z;
    overlap[k] = m.overlap, approach_speed[k] = m.approach_speed;
    slip_x[k] = m.slip_velocity.x, slip_y[k] = m.slip_velocity.y, slip_z[k] = m.slip_velocity.z;
    spin_ix[k] = m.spin_i.x, spin_iy[k] = m.spin_i.y, spin_iz[k] = m.spin_i.z;
    spin_jx[k] = m.spin_j.x, spin_jy[k] = m.spin_j.y, spin_jz[k] = m.spin_j.z;
    lever_i[k] = m.lever_i, lever_j[k] = m.lever_j;
}

void load_block(const Laws& laws, Contacts& contacts, std::size_t first, int size,
                const MotionBlock& motion, const Settings& settings) {
    const Slots c = slots(contacts, first);
    with_laws(laws, [&](const auto& law) {
        if (settings.ledger)
            load_typed<true>(law, c, motion, size, settings.time_step);
        else
            load_typed<false>(law, c, motion, size, settings.time_step);
    });
}

}  // namespace dem_min
