// SPDX-License-Identifier: MIT
// The grains' own half of a step: kicks, drift and weight, in loops that become vectors.
#include "dem_min/forces.hpp"
#include "dem_min/vector_clones.hpp"

#include <algorithm>
#include <cmath>

namespace dem_min {
namespace {

// One array each, [grains of the tile].
struct Arrays {
    double *x, *y, *z, *vx, *vy, *vz, *wx, *wy, *wz;
    double *fx, *fy, *fz, *tx, *ty, *tz;
    const double *mass, *inverse_mass, *inverse_inertia;
};

Arrays arrays(Particles& p, std::size_t k) {
    return {&p.x[k],  &p.y[k],  &p.z[k],  &p.vx[k],   &p.vy[k],           &p.vz[k],
            &p.wx[k], &p.wy[k], &p.wz[k], &p.fx[k],   &p.fy[k],           &p.fz[k],
            &p.tx[k], &p.ty[k], &p.tz[k], &p.mass[k], &p.inverse_mass[k], &p.inverse_inertia[k]};
}

inline Vec3 weighed(const Arrays& p, int k, Vec3 g) {
    return {p.fx[k] + p.mass[k] * g.x, p.fy[k] + p.mass[k] * g.y, p.fz[k] + p.mass[k] * g.z};
}

// One grain's half kick by the force f and its torque.
inline void kick_one(const Arrays& p, int k, Vec3 f, double half) {
    const double a = half * p.inverse_mass[k], b = half * p.inverse_inertia[k];
    p.vx[k] += a * f.x, p.vy[k] += a * f.y, p.vz[k] += a * f.z;
    p.wx[k] += b * p.tx[k], p.wy[k] += b * p.ty[k], p.wz[k] += b * p.tz[k];
}

SIMILITUDE_VECTOR_CLONES void weigh_and_kick(const Arrays p, int n, Vec3 g, double half) {
    SIMILITUDE_NO_DEPENDENCE
    for (int k = 0; k < n; ++k) {
        const Vec3 f = weighed(p, k, g);
        p.fx[k] = f.x, p.fy[k] = f.y, p.fz[k] = f.z;
        kick_one(p, k, f, half);
    }
}

// A vector's worth of grains at a time, so that sums and extremes are kept lane by lane.
constexpr int lanes = 8;
struct Lanes {
    double fastest[lanes], fastest_in_frame[lanes], fastest_spin[lanes], lost[lanes], bad[lanes];
    double vx[lanes], vy[lanes], vz[lanes];
};

inline void drift_one(const Arrays& p, int k, double dt, double lowest, Vec3 frame, Lanes& all,
                      int lane) {
    const double vx = p.vx[k], vy = p.vy[k], vz = p.vz[k];
    const double z = p.z[k] + dt * vz;
    p.x[k] += dt * vx, p.y[k] += dt * vy, p.z[k] = z;
    const double ux = vx - frame.x, uy = vy - frame.y, uz = vz - frame.z;
    const double v2 = vx * vx + vy * vy + vz * vz, u2 = ux * ux + uy * uy + uz * uz;
    all.fastest[lane] = v2 > all.fastest[lane] ? v2 : all.fastest[lane];
    all.fastest_in_frame[lane] = u2 > all.fastest_in_frame[lane] ? u2 : all.fastest_in_frame[lane];
    all.lost[lane] = z >= lowest ? all.lost[lane] : 1.0;
    const double w2 = p.wx[k] * p.wx[k] + p.wy[k] * p.wy[k] + p.wz[k] * p.wz[k];
    all.fastest_spin[lane] = w2 > all.fastest_spin[lane] ? w2 : all.fastest_spin[lane];
    const double sum = v2 + w2;
    all.bad[lane] = sum - sum == 0.0 ? all.bad[lane] : 1.0;  // neither infinite nor no number
    all.vx[lane] += vx, all.vy[lane] += vy, all.vz[lane] += vz;
}

// More arrays side by side than the processor follows by itself.
constexpr int ahead = 6;  // cache lines
inline void prefetch(const Arrays& p, int k) {
    for (const double* array :
         {p.x, p.y, p.z, p.vx, p.vy, p.vz, p.wx, p.wy, p.wz, p.fx, p.fy, p.fz, p.tx, p.ty, p.tz})
        __builtin_prefetch(array + k, 1);
    for (const double* array : {p.mass, p.inverse_mass, p.inverse_inertia})
        __builtin_prefetch(array + k, 0);
}

// `finish`: the second half of the last step comes first.
template <bool finish>
inline Drift walk(const Arrays& p, int n, const Settings& settings, Vec3 frame) {
    Lanes all{};
    const double dt = settings.time_step, half = 0.5 * dt, lowest = settings.lost_below;
    const Vec3 g = settings.gravity;
    const auto one = [&](int k, int lane) {
        Vec3 f{p.fx[k], p.fy[k], p.fz[k]};
        if constexpr (finish) {  // the force itself is not needed again
            f = weighed(p, k, g);
            kick_one(p, k, f, half);
        }
        kick_one(p, k, f, half);
        drift_one(p, k, dt, lowest, frame, all, lane);
    };
    int k = 0;
    for (; k + lanes <= n; k += lanes) {
        prefetch(p, k + ahead * lanes);
        SIMILITUDE_NO_DEPENDENCE
        for (int lane = 0; lane < lanes; ++lane) one(k + lane, lane);
    }
    for (; k < n; ++k) one(k, k % lanes);
    Drift drift{};
    for (int lane = 0; lane < lanes; ++lane) {
        drift.fastest = std::max(drift.fastest, all.fastest[lane]);
        drift.fastest_in_frame = std::max(drift.fastest_in_frame, all.fastest_in_frame[lane]);
        drift.fastest_spin = std::max(drift.fastest_spin, all.fastest_spin[lane]);
        drift.lost = drift.lost || all.lost[lane] > 0.0;
        drift.bad = drift.bad || all.bad[lane] > 0.0;
        drift.sum_of_velocities =
            drift.sum_of_velocities + Vec3{all.vx[lane], all.vy[lane], all.vz[lane]};
    }
    drift.fastest = std::sqrt(drift.fastest);
    drift.fastest_in_frame = std::sqrt(drift.fastest_in_frame);
    drift.fastest_spin = std::sqrt(drift.fastest_spin);
    return drift;
}

SIMILITUDE_VECTOR_CLONES Drift begin(const Arrays p, int n, const Settings settings, Vec3 frame) {
    return walk<false>(p, n, settings, frame);
}

SIMILITUDE_VECTOR_CLONES Drift finish_and_begin(const Arrays p, int n, const Settings settings,
                                                Vec3 frame) {
    return walk<true>(p, n, settings, frame);
}

void add_incoming(Simulation& s, const Tile& tile) {
    Particles& p = s.grains;
    for (const Incoming& in : tile.inbox) {
        const Outgoing& load =
            s.tiles[static_cast<std::size_t>(in.tile)].outbox[static_cast<std::size_t>(in.index)];
        const auto k = static_cast<std::size_t>(load.j);
        p.fx[k] += load.force.x, p.fy[k] += load.force.y, p.fz[k] += load.force.z;
        p.tx[k] += load.torque.x, p.ty[k] += load.torque.y, p.tz[k] += load.torque.z;
    }
}

}  // namespace

std::size_t first_of(std::size_t tile) { return tile * tile_size; }

int grains_of(const Simulation& s, std::size_t tile) {
    return static_cast<int>(std::min<std::size_t>(tile_size, s.grains.count() - first_of(tile)));
}

Drift begin_step(Simulation& s, std::size_t t) {
    return begin(arrays(s.grains, first_of(t)), grains_of(s, t), s.settings, s.frame);
}

void end_step(Simulation& s, std::size_t t) {
    add_incoming(s, s.tiles[t]);
    weigh_and_kick(arrays(s.grains, first_of(t)), grains_of(s, t), s.settings.gravity,
                   0.5 * s.settings.time_step);
}

Drift end_and_begin_step(Simulation& s, std::size_t t) {
    add_incoming(s, s.tiles[t]);
    return finish_and_begin(arrays(s.grains, first_of(t)), grains_of(s, t), s.settings, s.frame);
}

}  // namespace dem_min
