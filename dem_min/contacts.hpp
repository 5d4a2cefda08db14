// SPDX-License-Identifier: MIT
// Contacts that exist now, as a structure of arrays. Shape of every array: [count()]. A contact keeps its slot until it
// ends; then the last one moves into the gap. Forces are summed in the order of slots: see tiles.hpp.
#pragma once

#include "contact/vec3.hpp"
#include "dem_min/array.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace dem_min {

using contact::Vec3;

// What a pair keeps from birth to end.
struct ContactConstants {
    double r_i, r_j;      // m; r_j is 0 at a wall, whose surface is where the distance ends
    double r_star;        // m
    double m_star;        // kg; a wall and a fixed grain count as infinitely heavy
    double length_scale;  // m, of the normal law
    double inverse_inertia_i, inverse_inertia_j;  // 1/(kg m^2)
    friend bool operator==(const ContactConstants&, const ContactConstants&) = default;
};

// Energy that has become heat so far, J (only while the ledger is on): in a contact, or by the drag of a fluid.
struct Dissipation {
    double normal_dashpot = 0.0, tangential = 0.0, rolling = 0.0, tear_off = 0.0, drag = 0.0;
    double total() const { return normal_dashpot + tangential + rolling + tear_off + drag; }
    Dissipation& operator+=(const Dissipation&);
};

// What the energy ledger remembers of each contact; empty while it is off.
struct ContactBooks {
    Array overlap;                                     // m, of the last force evaluation
    Array nx, ny, nz, dashpot;                         // unit normal; N, normal damping force
    Array fx, fy, fz;                                  // N, on j
    Array tix, tiy, tiz, tjx, tjy, tjz;                // N m
    Array heat_normal, heat_tangential, heat_rolling;  // J, sums since birth
    Array heat_tear_off;  // J, likewise: of ageing, and of solids that parted under a bridge
    Array stored_tangential, stored_rolling;  // J; rolling includes twisting
};

struct Contacts {
    std::vector<int> i, j;  // grains; at a wall j is the wall
    Array r_star, m_star, length_scale;
    // History: tangential spring (m), rolling spring (rad or m, as the law says), twist (rad), contact radius of the
    // last step (m).
    Array sx, sy, sz, rx, ry, rz, twist, previous_radius;
    // s, since the solids touched; empty where contacts are not loaded singly (Laws::singly). Of these one whose
    // previous_radius is 0 and whose overlap is negative is a bridge across a gap, and nothing else.
    Array age;
    ContactBooks books;

    // True while all contacts have had the same constants, which stay: they are `common` then, and loops need not read them.
    bool alike = true;
    ContactConstants common{};

    std::size_t count() const { return i.size(); }
    void add(int grain_i, int partner_j, const ContactConstants&, bool with_books, bool singly);
    // The contacts of others, histories and all, between grains that may have new numbers.
    struct Copy {
        int i, j;
        const Contacts* from;
        std::size_t slot;
    };
    void append(const std::vector<Copy>&);
    void remove(std::size_t slot);  // the last contact takes the slot
    void clear();

    std::array<Array*, 32> arrays();  // books too
    std::array<const Array*, 32> arrays() const;
};

}  // namespace dem_min
