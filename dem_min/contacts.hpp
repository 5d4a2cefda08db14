// SPDX-License-Identifier: MIT
// The contacts that exist now, as a structure of arrays. Shape of every array: [count()]. A contact keeps its slot until
// it ends; then the last one moves into the gap. No sum depends on the order of slots: see Incidence in neighbours.hpp.
#pragma once

#include "contact/vec3.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace dem_min {

using contact::Vec3;

// What a pair keeps from birth to end.
struct ContactConstants {
    double r_i, r_j;      // m; r_j is infinite at a wall
    double r_star;        // m
    double m_star;        // kg; a wall and a fixed grain count as infinitely heavy
    double length_scale;  // m, of the normal law
    double inverse_inertia_i, inverse_inertia_j;  // 1/(kg m^2)
    double tear_off_overlap;                      // m, <= 0
};

// Energy that a contact has turned into heat so far, J (only while the ledger is on).
struct Dissipation {
    double normal_dashpot = 0.0, tangential = 0.0, rolling = 0.0, tear_off = 0.0;
    double total() const { return normal_dashpot + tangential + rolling + tear_off; }
    Dissipation& operator+=(const Dissipation&);
};

struct Contacts {
    std::vector<int> i, j;  // grains; in the list of wall contacts j is the wall
    std::vector<int>
        candidate;  // its place in the neighbour list; -1: beyond the reach of the list, about to end
    std::vector<double> r_i, r_j, r_star, m_star, length_scale, inverse_inertia_i,
        inverse_inertia_j, tear_off_overlap;
    // History: tangential spring (m), rolling spring (rad or m, as the law says), twist (rad), contact radius of the last step (m).
    std::vector<double> sx, sy, sz, rx, ry, rz, twist, previous_radius;
    std::vector<double> overlap;              // m, of the last force evaluation
    std::vector<double> nx, ny, nz, dashpot;  // unit normal; N, normal damping force; both likewise
    std::vector<double> fx, fy, fz;           // N, on j
    std::vector<double> tix, tiy, tiz, tjx, tjy, tjz;                // N m
    std::vector<double> heat_normal, heat_tangential, heat_rolling;  // J, sums since birth
    std::vector<double> stored_tangential,
        stored_rolling;  // J; rolling includes twisting, in heat too

    std::size_t count() const { return i.size(); }
    void add(int grain_i, int partner_j, int candidate_index, const ContactConstants&);
    void remove(std::size_t slot);  // the last contact takes the slot

    std::array<std::vector<double>*, 35> arrays();
};

}  // namespace dem_min
