// SPDX-License-Identifier: MIT
#include "dem_min/forces.hpp"
#include "dem_min/vector_clones.hpp"

#include <type_traits>

namespace dem_min {
namespace {

// Where a block of contacts stands in memory. Raw pointers, so that the loop below sees that nothing moves.
struct Slots {
    const double *r_star, *m_star, *length_scale;
    double *sx, *sy, *sz, *rx, *ry, *rz, *twist, *previous_radius;
};

struct BookSlots {
    double *overlap, *nx, *ny, *nz, *dashpot;
    double *fx, *fy, *fz, *tix, *tiy, *tiz, *tjx, *tjy, *tjz;
    double *heat_normal, *heat_tangential, *heat_rolling, *heat_tear_off;
    double *stored_tangential, *stored_rolling;
};

Slots slots(Contacts& c, std::size_t k) {
    return {&c.r_star[k],
            &c.m_star[k],
            &c.length_scale[k],
            &c.sx[k],
            &c.sy[k],
            &c.sz[k],
            &c.rx[k],
            &c.ry[k],
            &c.rz[k],
            &c.twist[k],
            &c.previous_radius[k]};
}

BookSlots slots(ContactBooks& b, std::size_t k) {
    return {&b.overlap[k],
            &b.nx[k],
            &b.ny[k],
            &b.nz[k],
            &b.dashpot[k],
            &b.fx[k],
            &b.fy[k],
            &b.fz[k],
            &b.tix[k],
            &b.tiy[k],
            &b.tiz[k],
            &b.tjx[k],
            &b.tjy[k],
            &b.tjz[k],
            &b.heat_normal[k],
            &b.heat_tangential[k],
            &b.heat_rolling[k],
            &b.heat_tear_off[k],
            &b.stored_tangential[k],
            &b.stored_rolling[k]};
}

SIMILITUDE_VECTOR_CLONES void fold(double* way, int size, double period) {
    const double inverse = 1.0 / period;
    for (int k = 0; k < size; ++k) way[k] = nearest_image(way[k], period, inverse);
}

SIMILITUDE_VECTOR_CLONES void aim(Block& b, int size) {
    for (int k = 0; k < size; ++k) {
        const Vec3 apart{b.nx[k], b.ny[k], b.nz[k]};
        const double d = contact::norm(apart);
        const Vec3 n = (1.0 / d) * apart;
        b.nx[k] = n.x, b.ny[k] = n.y, b.nz[k] = n.z;
        b.distance[k] = d;
    }
}

inline Motion motion(const Block& b, int k, double r_i, double r_j) {
    const Vec3 n{b.nx[k], b.ny[k], b.nz[k]};
    const double overlap = (r_i + r_j) - b.distance[k];
    const double lever_i = r_i - 0.5 * overlap, lever_j = r_j - 0.5 * overlap;
    const Vec3 spin_i{b.ix[k], b.iy[k], b.iz[k]}, spin_j{b.jx[k], b.jy[k], b.jz[k]};
    const Vec3 relative{b.ux[k], b.uy[k], b.uz[k]};
    const Vec3 slip = contact::tangential_part(relative, n) -
                      contact::cross(lever_i * spin_i + lever_j * spin_j, n);
    return {n, overlap, -contact::dot(relative, n), slip, spin_i, spin_j, lever_i, lever_j};
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

// Adds what became heat on the way from the last positions to these, at contact k, whose books still hold the last step.
// Over that way each load acts for half a step with its old and for half a step with its new value: their mean times the way
// is the work that the motion lost, exactly, and what springs do not keep of it is heat. The laws' own count of a step takes
// the new value for the whole way, an error of first order in the step.
inline void add_heat(const BookSlots& books, const Block& b, int k, double overlap_before,
                     const Motion& m, const Push& pushed, const Turn& turned, double dt) {
    if (m.overlap == handed_over) return;
    const Vec3 force{b.fx[k], b.fy[k], b.fz[k]};
    const Resistance before = resistance(
        {books.fx[k], books.fy[k], books.fz[k]}, {books.tix[k], books.tiy[k], books.tiz[k]},
        {books.tjx[k], books.tjy[k], books.tjz[k]}, {books.nx[k], books.ny[k], books.nz[k]},
        b.r_i[k] - 0.5 * overlap_before, b.r_j[k] - 0.5 * overlap_before);
    const Resistance now =
        resistance(force, turned.torque_on_i, turned.torque_on_j, m.n, m.lever_i, m.lever_j);
    const double way = 0.5 * dt;
    const double acts = b.hold[k] >= 0.0 ? way : 0.0;  // a torn contact loads nobody any more
    books.heat_normal[k] += (way * books.dashpot[k] + acts * pushed.dashpot) * m.approach_speed;
    books.heat_tangential[k] +=
        books.stored_tangential[k] - pushed.stored -
        contact::dot(way * before.friction + acts * now.friction, m.slip_velocity);
    books.heat_rolling[k] += books.stored_rolling[k] - turned.stored -
                             contact::dot(way * before.rolling_i + acts * now.rolling_i, m.spin_i) -
                             contact::dot(way * before.rolling_j + acts * now.rolling_j, m.spin_j);
    books.stored_tangential[k] = pushed.stored;
    books.stored_rolling[k] = turned.stored;
    books.dashpot[k] = pushed.dashpot;
    books.nx[k] = m.n.x, books.ny[k] = m.n.y, books.nz[k] = m.n.z;
    books.fx[k] = force.x, books.fy[k] = force.y, books.fz[k] = force.z;
    books.tix[k] = b.tix[k], books.tiy[k] = b.tiy[k], books.tiz[k] = b.tiz[k];
    books.tjx[k] = b.tjx[k], books.tjy[k] = b.tjy[k], books.tjz[k] = b.tjz[k];
}

// The constants of all contacts where they are alike, or else the contact's own.
template <bool alike>
inline ContactConstants constants_of(const Slots& c, const Block& b, int k,
                                     const ContactConstants& common) {
    if constexpr (
        alike)  // member by member: a copy of the whole would keep g++ 12 from making vectors
        return {common.r_i,
                common.r_j,
                common.r_star,
                common.m_star,
                common.length_scale,
                common.inverse_inertia_i,
                common.inverse_inertia_j};
    return {b.r_i[k],
            b.r_j[k],
            c.r_star[k],
            c.m_star[k],
            c.length_scale[k],
            b.inverse_inertia_i[k],
            b.inverse_inertia_j[k]};
}

template <class Interaction>
constexpr bool twists = !std::is_same_v<decltype(Interaction::twisting), contact::NoTwisting>;

inline void note(const contact::Slider&, Block&, int) {}
inline void note(const contact::StuckSlider& slider, Block& b, int k) { b.slid[k] = slider.slid; }

// The three stages of a contact's load, one loop each. Their roots and quotients wait for one another, and a processor has room
// for many turns of a short loop at a time, but not of a long one.
template <bool alike, class Interaction>
inline void press_one(const Interaction& law, const Slots& c, Block& b, int k,
                      const ContactConstants& common) {
    const ContactConstants constants = constants_of<alike>(c, b, k, common);
    const double r_star = constants.r_star, length_scale = constants.length_scale;
    const double overlap = (constants.r_i + constants.r_j) - b.distance[k];
    const contact::NormalState elastic = law.normal.at(r_star, length_scale, overlap);
    b.elastic_force[k] = elastic.force;
    b.contact_radius[k] = elastic.contact_radius;
    b.hold[k] = overlap - law.normal.tear_off_overlap(r_star, length_scale);
}

template <bool alike, class AnySlider, class Interaction>
inline Push push_one(const Interaction& law, const Slots& c, Block& b, int k,
                     const ContactConstants& common, double dt) {
    const ContactConstants constants = constants_of<alike>(c, b, k, common);
    const Motion m = motion(b, k, constants.r_i, constants.r_j);
    AnySlider slider;
    const Push pushed = push(law, constants, {b.elastic_force[k], b.contact_radius[k]}, m,
                             {c.sx[k], c.sy[k], c.sz[k]}, c.previous_radius[k], dt, slider);
    const Vec3 force = pushed.normal_force * m.n + pushed.friction_on_j;
    b.fx[k] = force.x, b.fy[k] = force.y, b.fz[k] = force.z;
    b.qx[k] = pushed.friction_on_j.x, b.qy[k] = pushed.friction_on_j.y;
    b.qz[k] = pushed.friction_on_j.z;
    b.cap_force[k] = pushed.cap_force;
    b.sx[k] = pushed.spring.x, b.sy[k] = pushed.spring.y, b.sz[k] = pushed.spring.z;
    note(slider, b, k);
    return pushed;
}

template <bool alike, class AnySlider, class Interaction>
inline Turn turn_one(const Interaction& law, const Slots& c, Block& b, int k,
                     const ContactConstants& common, double dt) {
    const ContactConstants constants = constants_of<alike>(c, b, k, common);
    const Motion m = motion(b, k, constants.r_i, constants.r_j);
    AnySlider slider;
    const Turn turned =
        turn(law, constants, b.contact_radius[k], b.cap_force[k], {b.qx[k], b.qy[k], b.qz[k]}, m,
             {c.rx[k], c.ry[k], c.rz[k]}, twists<Interaction> ? c.twist[k] : 0.0,
             c.previous_radius[k], dt, slider);
    b.tix[k] = turned.torque_on_i.x, b.tiy[k] = turned.torque_on_i.y;
    b.tiz[k] = turned.torque_on_i.z;
    b.tjx[k] = turned.torque_on_j.x, b.tjy[k] = turned.torque_on_j.y;
    b.tjz[k] = turned.torque_on_j.z;
    b.rx[k] = turned.spring.x, b.ry[k] = turned.spring.y, b.rz[k] = turned.spring.z;
    if constexpr (twists<Interaction>) b.twist[k] = turned.twist;
    note(slider, b, k);
    return turned;
}

template <class Interaction>
inline void keep_one(const Interaction&, const Slots& c, const Block& b, int k) {
    c.sx[k] = b.sx[k], c.sy[k] = b.sy[k], c.sz[k] = b.sz[k];
    c.rx[k] = b.rx[k], c.ry[k] = b.ry[k], c.rz[k] = b.rz[k];
    if constexpr (twists<Interaction>) c.twist[k] = b.twist[k];
    c.previous_radius[k] = b.contact_radius[k];
}

inline bool any_slid(const Block& b, int size) {
    int slid = 0;
    for (int k = 0; k < size; ++k) slid += b.slid[k] > 0.0;
    return slid > 0;
}

// Few blocks have a contact that slides. All are tried as if none did, and those few once more.
template <bool alike, class Interaction>
SIMILITUDE_VECTOR_CLONES void load_fast(const Interaction law, const Slots c, Block& b, int size,
                                        const ContactConstants common, double dt) {
    using contact::Slider, contact::StuckSlider;
    SIMILITUDE_NO_DEPENDENCE
    for (int k = 0; k < size; ++k) press_one<alike>(law, c, b, k, common);
    SIMILITUDE_NO_DEPENDENCE
    for (int k = 0; k < size; ++k) push_one<alike, StuckSlider>(law, c, b, k, common, dt);
    if (any_slid(b, size)) {
        SIMILITUDE_NO_DEPENDENCE
        for (int k = 0; k < size; ++k) push_one<alike, Slider>(law, c, b, k, common, dt);
    }
    SIMILITUDE_NO_DEPENDENCE
    for (int k = 0; k < size; ++k) turn_one<alike, StuckSlider>(law, c, b, k, common, dt);
    if (any_slid(b, size)) {
        SIMILITUDE_NO_DEPENDENCE
        for (int k = 0; k < size; ++k) turn_one<alike, Slider>(law, c, b, k, common, dt);
    }
    SIMILITUDE_NO_DEPENDENCE
    for (int k = 0; k < size; ++k) keep_one(law, c, b, k);
}

// The normal law of a contact that has become older by a step, unless it is new. What adhesion gains of itself is heat.
template <class Normal>
Normal grown_older(const Normal& fresh, const contact::Ageing& ageing, Contacts& c,
                   std::size_t slot, const Settings& settings) {
    double &age = c.age[slot], &length_scale = c.length_scale[slot];
    const double r_star = c.r_star[slot], age_before = age;
    if (c.previous_radius[slot] > 0.0) age += settings.time_step;
    const Normal law = ageing.aged(fresh, age);
    length_scale = law.length_scale(r_star);
    if (settings.ledger) {
        const double overlap = c.books.overlap[slot];
        const Normal younger = ageing.aged(fresh, age_before);
        c.books.heat_tear_off[slot] +=
            younger.energy(r_star, younger.length_scale(r_star), overlap) -
            law.energy(r_star, length_scale, overlap);
    }
    return law;
}

template <class Interaction>
bool solids_touch(const Interaction& law, const Slots& c, const Block& b, int k) {
    const double overlap = (b.r_i[k] + b.r_j[k]) - b.distance[k];
    const double tear_off = law.normal.tear_off_overlap(c.r_star[k], c.length_scale[k]);
    return overlap >= 0.0 || (c.previous_radius[k] > 0.0 && overlap >= tear_off);
}

// A bridge across a gap, which is all that there is of contact k.
void bridge_one(const contact::CapillaryBridge& bridge, const Slots& c, Block& b, int k) {
    const double gap = b.distance[k] - (b.r_i[k] + b.r_j[k]);
    const double pull = bridge.across(c.r_star[k], gap);
    b.fx[k] = -pull * b.nx[k], b.fy[k] = -pull * b.ny[k], b.fz[k] = -pull * b.nz[k];
    for (double* torque : {b.tix, b.tiy, b.tiz, b.tjx, b.tjy, b.tjz}) torque[k] = 0.0;
    for (double* history : {c.sx, c.sy, c.sz, c.rx, c.ry, c.rz, c.twist, c.previous_radius})
        history[k] = 0.0;
    b.hold[k] = bridge.rupture_gap - gap;
}

// Where the solids part, the work of their tear-off is heat; where a mesh hands a grain over, a bridge across a gap is lost.
template <class Normal>
double heat_of_parting(const Normal& law, const contact::CapillaryBridge& bridge, const Slots& c,
                       const Block& b, int k, bool touched, double overlap_before) {
    const bool handed = b.distance[k] == -handed_over;
    if (handed == touched) return 0.0;
    if (handed) return bridge.work(c.r_star[k], -overlap_before);
    const double r_star = c.r_star[k], tear_off = law.tear_off_overlap(r_star, c.length_scale[k]);
    return law.energy(r_star, c.length_scale[k], tear_off) - bridge.closed(r_star) * tear_off -
           bridge.work(r_star, -tear_off < bridge.rupture_gap ? -tear_off : bridge.rupture_gap);
}

// Contact by contact, with a bridge or ageing; and with the ledger: the same loads, and the books. Not made for speed.
template <class Interaction>
void load_singly(Interaction law, const Laws& laws, Contacts& contacts, std::size_t first, Block& b,
                 int size, const Settings& settings) {
    const Slots c = slots(contacts, first);
    const auto fresh = law.normal;
    const double dt = settings.time_step;
    for (int k = 0; k < size; ++k) {
        const std::size_t slot = first + static_cast<std::size_t>(k);
        if (laws.ageing.acts())
            law.normal = grown_older(fresh, laws.ageing, contacts, slot, settings);
        const double overlap_before = settings.ledger ? contacts.books.overlap[slot] : 0.0;
        const bool touched = c.previous_radius[k] > 0.0;
        const bool touch = !laws.bridge.acts() || solids_touch(law, c, b, k);
        Push pushed{};
        Turn turned{};
        if (touch) {
            press_one<false>(law, c, b, k, {});
            pushed = push_one<false, contact::Slider>(law, c, b, k, {}, dt);
            turned = turn_one<false, contact::Slider>(law, c, b, k, {}, dt);
            keep_one(law, c, b, k);
            if (laws.bridge.acts()) {
                const double pull = laws.bridge.closed(c.r_star[k]);
                b.fx[k] -= pull * b.nx[k], b.fy[k] -= pull * b.ny[k], b.fz[k] -= pull * b.nz[k];
            }
        } else {
            bridge_one(laws.bridge, c, b, k);
            contacts.age[slot] = 0.0;
        }
        if (!settings.ledger) continue;
        const BookSlots books = slots(contacts.books, first);
        if (!touch)
            books.heat_tear_off[k] +=
                heat_of_parting(law.normal, laws.bridge, c, b, k, touched, overlap_before);
        const Motion m = motion(b, k, b.r_i[k], b.r_j[k]);
        books.overlap[k] = m.overlap;
        add_heat(books, b, k, overlap_before, m, pushed, turned, dt);
    }
}

}  // namespace

void gather_pairs(const Simulation& s, const Contacts& c, std::size_t first, int size, Block& b) {
    const Particles& p = s.grains;
    const double *x = p.x.data(), *y = p.y.data(), *z = p.z.data();
    const double *vx = p.vx.data(), *vy = p.vy.data(), *vz = p.vz.data();
    const double *wx = p.wx.data(), *wy = p.wy.data(), *wz = p.wz.data();
    const int *from = c.i.data() + first, *to = c.j.data() + first;
    for (int k = 0; k < size; ++k) {
        if (const std::size_t ahead = first + static_cast<std::size_t>(k) + block_size;
            k % asked_at_a_time == 0 && ahead < c.count())
            for (const double* array : {x, y, z, vx, vy, vz, wx, wy, wz})
                __builtin_prefetch(array + c.j[ahead]);
        const int i = from[k], j = to[k];
        b.nx[k] = x[j] - x[i], b.ny[k] = y[j] - y[i], b.nz[k] = z[j] - z[i];
        b.ux[k] = vx[j] - vx[i], b.uy[k] = vy[j] - vy[i], b.uz[k] = vz[j] - vz[i];
        b.ix[k] = wx[i], b.iy[k] = wy[i], b.iz[k] = wz[i];
        b.jx[k] = wx[j], b.jy[k] = wy[j], b.jz[k] = wz[j];
    }
    if (!c.alike || s.settings.ledger)
        for (int k = 0; k < size; ++k) {
            const auto i = static_cast<std::size_t>(from[k]), j = static_cast<std::size_t>(to[k]);
            b.r_i[k] = p.radius[i], b.r_j[k] = p.radius[j];
            b.inverse_inertia_i[k] = p.inverse_inertia[i];
            b.inverse_inertia_j[k] = p.inverse_inertia[j];
        }
    if (s.settings.period_x > 0.0) fold(b.nx, size, s.settings.period_x);
    if (s.settings.period_y > 0.0) fold(b.ny, size, s.settings.period_y);
    aim(b, size);
}

void gather_walls(const Simulation& s, const Contacts& c, std::size_t first, int size, Block& b) {
    const Particles& p = s.grains;
    for (int k = 0; k < size; ++k) {
        const auto i = static_cast<std::size_t>(c.i[first + static_cast<std::size_t>(k)]);
        const auto wall = static_cast<std::size_t>(c.j[first + static_cast<std::size_t>(k)]);
        const WallDistance way = distance(s.walls[wall], p.position(i));
        b.nx[k] = way.n.x, b.ny[k] = way.n.y, b.nz[k] = way.n.z;
        b.distance[k] = way.distance;
        const Vec3 u =
            velocity(s.walls[wall], p.position(i) + way.distance * way.n) - p.velocity(i);
        const Vec3 turn = spin(s.walls[wall]);
        b.ux[k] = u.x, b.uy[k] = u.y, b.uz[k] = u.z;
        b.ix[k] = p.wx[i], b.iy[k] = p.wy[i], b.iz[k] = p.wz[i];
        b.jx[k] = turn.x, b.jy[k] = turn.y, b.jz[k] = turn.z;
        b.r_i[k] = p.radius[i], b.r_j[k] = 0.0;
        b.inverse_inertia_i[k] = p.inverse_inertia[i], b.inverse_inertia_j[k] = 0.0;
    }
}

void load_block(const Laws& laws, Contacts& contacts, std::size_t first, int size, Block& block,
                const Settings& settings) {
    const Slots c = slots(contacts, first);
    const double dt = settings.time_step;
    with_laws(laws, [&](const auto& law) {
        if (settings.ledger || laws.singly())
            load_singly(law, laws, contacts, first, block, size, settings);
        else if (contacts.alike)
            load_fast<true>(law, c, block, size, contacts.common, dt);
        else
            load_fast<false>(law, c, block, size, contacts.common, dt);
    });
}

}  // namespace dem_min
