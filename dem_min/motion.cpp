// SPDX-License-Identifier: MIT
// The grains' own half of a step: kicks, drift and weight, in loops that become vectors.
#include "dem_min/forces.hpp"
#include "dem_min/vector_clones.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace dem_min {
namespace {

// One array each, [grains of the tile].
struct Arrays {
    double *x, *y, *z, *vx, *vy, *vz, *wx, *wy, *wz;
    const double *fx, *fy, *fz, *tx, *ty, *tz;
    const double *mass, *inverse_mass, *inverse_inertia, *radius;
};

Arrays arrays(Particles& p, std::size_t k) {
    return {&p.x[k],     &p.y[k],  &p.z[k],  &p.vx[k],   &p.vy[k],           &p.vz[k],
            &p.wx[k],    &p.wy[k], &p.wz[k], &p.fx[k],   &p.fy[k],           &p.fz[k],
            &p.tx[k],    &p.ty[k], &p.tz[k], &p.mass[k], &p.inverse_mass[k], &p.inverse_inertia[k],
            &p.radius[k]};
}

// The loads of a tile, each component by itself. The arrays begin at different places of a page, for the reason that array.hpp
// gives.
struct Sums {
    static constexpr int stride = tile_size + 8;  // one cache line apart
    double fx[stride], fy[stride], fz[stride], tx[stride], ty[stride], tz[stride];
};

// Component by component, of four grains.
inline void turn(const Four& a, const Four& b, const Four& c, const Four& d, double* x, double* y,
                 double* z) {
    const Four xz_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const Four yw_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Four xz_cd = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const Four yw_cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    const Four xs = __builtin_shufflevector(xz_ab, xz_cd, 0, 1, 4, 5);
    const Four ys = __builtin_shufflevector(yw_ab, yw_cd, 0, 1, 4, 5);
    const Four zs = __builtin_shufflevector(xz_ab, xz_cd, 2, 3, 6, 7);
    std::memcpy(x, &xs, sizeof xs), std::memcpy(y, &ys, sizeof ys), std::memcpy(z, &zs, sizeof zs);
}

SIMILITUDE_VECTOR_CLONES void turn_all(const Load* of, int n, Sums& sums) {
    int k = 0;
    for (; k + 4 <= n; k += 4) {
        const Load *a = of + k, *b = a + 1, *c = a + 2, *d = a + 3;
        turn(a->force, b->force, c->force, d->force, sums.fx + k, sums.fy + k, sums.fz + k);
        turn(a->torque, b->torque, c->torque, d->torque, sums.tx + k, sums.ty + k, sums.tz + k);
    }
    for (; k < n; ++k) {
        const Four f = of[k].force, t = of[k].torque;
        sums.fx[k] = f[0], sums.fy[k] = f[1], sums.fz[k] = f[2];
        sums.tx[k] = t[0], sums.ty[k] = t[1], sums.tz[k] = t[2];
    }
}

// With the loads of this step, in which the weight is not yet.
Arrays arrays(Particles& p, std::size_t k, const Sums& sum) {
    Arrays all = arrays(p, k);
    all.fx = sum.fx, all.fy = sum.fy, all.fz = sum.fz;
    all.tx = sum.tx, all.ty = sum.ty, all.tz = sum.tz;
    return all;
}

inline Vec3 weighed(const Arrays& p, int k, Vec3 g) {
    return {p.fx[k] + p.mass[k] * g.x, p.fy[k] + p.mass[k] * g.y, p.fz[k] + p.mass[k] * g.z};
}

// What every grain of a step is in.
struct Around {
    Field field;
    contact::DragSchiller1935 drag;
    double half;  // s, half a step
};

// Loads with weight, buoyancy and the drag D. The step wants D at the velocity v after this half kick, which holds D itself:
//   v = v* + (h/m) D(v),   v* = v(t - h) + (h/m) F,   F all other forces, h half a step.
// One step of Newton from v* gives D = -r u*/(1 + (h/m)(r + |u| dr/d|u|)), u* = v* less the wind: to second order the implicit
// midpoint rule for velocities, exactly that where r is a constant, and stable for every h.
inline Vec3 weighed_in_fluid(const Arrays& p, int k, const Around& in) {
    const Vec3 weight = weighed(p, k, in.field.per_mass);
    const double radius = p.radius[k];
    const Vec3 f = weight + volume_of(radius) * in.field.per_volume;
    const double a = in.half * p.inverse_mass[k];
    const Vec3 v{p.vx[k], p.vy[k], p.vz[k]};
    const Vec3 u = v + a * f - in.field.wind;
    const auto r = in.drag.at(2.0 * radius, std::sqrt(contact::dot(u, u)));
    return f - r.value / (1.0 + a * (r.value + r.growth)) * u;
}

template <bool fluid>
Vec3 weighed(const Arrays& p, int k, const Around& in) {
    if constexpr (fluid) return weighed_in_fluid(p, k, in);
    return weighed(p, k, in.field.per_mass);
}

// Where loads are kept from one step to the next.
struct Kept {
    double *fx, *fy, *fz, *tx, *ty, *tz;
};

// One grain's half kick by the force f and its torque.
inline void kick_one(const Arrays& p, int k, Vec3 f, double half) {
    const double a = half * p.inverse_mass[k], b = half * p.inverse_inertia[k];
    p.vx[k] += a * f.x, p.vy[k] += a * f.y, p.vz[k] += a * f.z;
    p.wx[k] += b * p.tx[k], p.wy[k] += b * p.ty[k], p.wz[k] += b * p.tz[k];
}

template <bool fluid>
inline void weigh_and_kick_all(const Arrays& p, const Kept& kept, int n, const Around& in) {
    SIMILITUDE_NO_DEPENDENCE
    for (int k = 0; k < n; ++k) {
        const Vec3 f = weighed<fluid>(p, k, in);
        kept.fx[k] = f.x, kept.fy[k] = f.y, kept.fz[k] = f.z;
        kept.tx[k] = p.tx[k], kept.ty[k] = p.ty[k], kept.tz[k] = p.tz[k];
        kick_one(p, k, f, in.half);
    }
}

SIMILITUDE_VECTOR_CLONES void weigh_and_kick(const Arrays p, const Kept kept, int n,
                                             const Around in) {
    weigh_and_kick_all<false>(p, kept, n, in);
}

SIMILITUDE_VECTOR_CLONES void weigh_and_kick_in_fluid(const Arrays p, const Kept kept, int n,
                                                      const Around in) {
    weigh_and_kick_all<true>(p, kept, n, in);
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
    for (const double* array : {p.x, p.y, p.z, p.vx, p.vy, p.vz, p.wx, p.wy, p.wz})
        __builtin_prefetch(array + k, 1);
    for (const double* array :
         {p.fx, p.fy, p.fz, p.tx, p.ty, p.tz, p.mass, p.inverse_mass, p.inverse_inertia})
        __builtin_prefetch(array + k, 0);
}

// `finish`: the second half of the last step comes first.
template <bool finish, bool fluid>
inline Drift walk(const Arrays& p, int n, const Settings& settings, Vec3 frame, const Around& in) {
    Lanes all{};
    const double dt = settings.time_step, half = 0.5 * dt, lowest = settings.lost_below;
    const auto one = [&](int k, int lane) {
        Vec3 f{p.fx[k], p.fy[k], p.fz[k]};
        if constexpr (finish) {  // the force itself is not needed again
            f = weighed<fluid>(p, k, in);
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
    return walk<false, false>(p, n, settings, frame, {});
}

SIMILITUDE_VECTOR_CLONES Drift finish_and_begin(const Arrays p, int n, const Settings settings,
                                                Vec3 frame, const Around in) {
    return walk<true, false>(p, n, settings, frame, in);
}

SIMILITUDE_VECTOR_CLONES Drift finish_and_begin_in_fluid(const Arrays p, int n,
                                                         const Settings settings, Vec3 frame,
                                                         const Around in) {
    return walk<true, true>(p, n, settings, frame, in);
}

Around around(const Simulation& s) {
    return {field_at(s.settings, s.time()), s.settings.fluid.drag, 0.5 * s.settings.time_step};
}

// Adds the loads that other tiles hold for these grains.
SIMILITUDE_VECTOR_CLONES void add_incoming(const Tile* tiles, const std::vector<Incoming>& inbox,
                                           Load* sum) {
    const auto entry = [&](const Incoming& in) {
        return tiles[static_cast<std::size_t>(in.tile)].outbox.loads.data() + in.index;
    };
    constexpr std::size_t far = 24;  // entries; the third-level cache answers within that
    for (std::size_t at = 0; at < inbox.size(); ++at) {
        if (at + far < inbox.size()) __builtin_prefetch(entry(inbox[at + far]));
        const Load& load = *entry(inbox[at]);
        Load& to = sum[inbox[at].place];
        to.force += load.force;
        to.torque += load.torque;
    }
}

void add_all(Simulation& s, std::size_t t, Sums& sums) {
    Load* const of = s.tiles[t].loads.data();
    add_incoming(s.tiles.data(), s.tiles[t].inbox, of);
    turn_all(of, grains_of(s, t), sums);
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
    Sums sum;
    add_all(s, t, sum);
    Particles& p = s.grains;
    const std::size_t k = first_of(t);
    const Kept kept{&p.fx[k], &p.fy[k], &p.fz[k], &p.tx[k], &p.ty[k], &p.tz[k]};
    (s.settings.fluid.acts() ? weigh_and_kick_in_fluid : weigh_and_kick)(
        arrays(p, k, sum), kept, grains_of(s, t), around(s));
}

Drift end_and_begin_step(Simulation& s, std::size_t t) {
    Sums sum;
    add_all(s, t, sum);
    return (s.settings.fluid.acts() ? finish_and_begin_in_fluid : finish_and_begin)(
        arrays(s.grains, first_of(t), sum), grains_of(s, t), s.settings, s.frame, around(s));
}

}  // namespace dem_min
