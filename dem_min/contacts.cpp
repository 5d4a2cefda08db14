// SPDX-License-Identifier: MIT
#include "dem_min/contacts.hpp"

namespace dem_min {

Dissipation& Dissipation::operator+=(const Dissipation& other) {
    normal_dashpot += other.normal_dashpot;
    tangential += other.tangential;
    rolling += other.rolling;
    tear_off += other.tear_off;
    return *this;
}

std::array<std::vector<double>*, 35> Contacts::arrays() {
    return {&r_i,
            &r_j,
            &r_star,
            &m_star,
            &length_scale,
            &inverse_inertia_i,
            &inverse_inertia_j,
            &tear_off_overlap,
            &sx,
            &sy,
            &sz,
            &rx,
            &ry,
            &rz,
            &twist,
            &previous_radius,
            &overlap,
            &nx,
            &ny,
            &nz,
            &dashpot,
            &fx,
            &fy,
            &fz,
            &tix,
            &tiy,
            &tiz,
            &tjx,
            &tjy,
            &tjz,
            &heat_normal,
            &heat_tangential,
            &heat_rolling,
            &stored_tangential,
            &stored_rolling};
}

void Contacts::add(int grain_i, int partner_j, int candidate_index,
                   const ContactConstants& constants) {
    i.push_back(grain_i);
    j.push_back(partner_j);
    candidate.push_back(candidate_index);
    for (std::vector<double>* array : arrays()) array->push_back(0.0);
    const std::size_t c = count() - 1;
    r_i[c] = constants.r_i;
    r_j[c] = constants.r_j;
    r_star[c] = constants.r_star;
    m_star[c] = constants.m_star;
    length_scale[c] = constants.length_scale;
    inverse_inertia_i[c] = constants.inverse_inertia_i;
    inverse_inertia_j[c] = constants.inverse_inertia_j;
    tear_off_overlap[c] = constants.tear_off_overlap;
}

void Contacts::remove(std::size_t slot) {
    i[slot] = i.back(), i.pop_back();
    j[slot] = j.back(), j.pop_back();
    candidate[slot] = candidate.back(), candidate.pop_back();
    for (std::vector<double>* array : arrays()) (*array)[slot] = array->back(), array->pop_back();
}

}  // namespace dem_min
