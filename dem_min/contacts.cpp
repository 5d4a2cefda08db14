// SPDX-License-Identifier: MIT
#include "dem_min/contacts.hpp"

namespace dem_min {
namespace {

template <class Visit>
void visit_state(auto& c, Visit&& each) {
    for (auto* array : {&c.r_star, &c.m_star, &c.length_scale, &c.sx, &c.sy, &c.sz, &c.rx, &c.ry,
                        &c.rz, &c.twist, &c.previous_radius})
        each(*array);
}

template <class Visit>
void visit_books(auto& b, Visit&& each) {
    for (auto* array : {&b.overlap, &b.nx, &b.ny, &b.nz, &b.dashpot, &b.fx, &b.fy, &b.fz, &b.tix,
                        &b.tiy, &b.tiz, &b.tjx, &b.tjy, &b.tjz, &b.heat_normal, &b.heat_tangential,
                        &b.heat_rolling, &b.stored_tangential, &b.stored_rolling})
        each(*array);
}

bool has_books(const Contacts& c) { return c.books.nx.size() == c.count() && c.count() > 0; }

}  // namespace

Dissipation& Dissipation::operator+=(const Dissipation& other) {
    normal_dashpot += other.normal_dashpot;
    tangential += other.tangential;
    rolling += other.rolling;
    tear_off += other.tear_off;
    return *this;
}

namespace {

template <class Pointer>
std::array<Pointer, 30> all_arrays(auto& contacts) {
    std::array<Pointer, 30> all;
    auto next = all.begin();
    const auto note = [&](auto& array) { *next++ = &array; };
    visit_state(contacts, note);
    visit_books(contacts.books, note);
    return all;
}

}  // namespace

std::array<Array*, 30> Contacts::arrays() { return all_arrays<Array*>(*this); }

std::array<const Array*, 30> Contacts::arrays() const { return all_arrays<const Array*>(*this); }

void Contacts::add(int grain_i, int partner_j, const ContactConstants& constants, bool with_books) {
    if (count() == 0) alike = true, common = constants;
    alike = alike && constants == common;
    const auto push_zero = [](Array& array) { array.push_back(0.0); };
    visit_state(*this, push_zero);
    if (with_books) visit_books(books, push_zero);
    i.push_back(grain_i);
    j.push_back(partner_j);
    r_star.back() = constants.r_star;
    m_star.back() = constants.m_star;
    length_scale.back() = constants.length_scale;
}

void Contacts::append(const std::vector<Copy>& copies) {
    const auto to = arrays();
    for (std::size_t first = 0, last = 0; first < copies.size(); first = last) {
        const Contacts& other = *copies[first].from;
        while (last < copies.size() && copies[last].from == &other) ++last;
        if (count() == 0) alike = other.alike, common = other.common;
        alike = alike && other.alike && other.common == common;
        const auto from = other.arrays();
        for (std::size_t a = 0; a < to.size(); ++a)
            if (!from[a]->empty())
                for (std::size_t k = first; k < last; ++k)
                    to[a]->push_back((*from[a])[copies[k].slot]);
        for (std::size_t k = first; k < last; ++k)
            i.push_back(copies[k].i), j.push_back(copies[k].j);
    }
}

void Contacts::remove(std::size_t slot) {
    const auto take_last = [slot](Array& array) {
        array[slot] = array.back();
        array.pop_back();
    };
    if (has_books(*this)) visit_books(books, take_last);
    visit_state(*this, take_last);
    i[slot] = i.back(), i.pop_back();
    j[slot] = j.back(), j.pop_back();
}

void Contacts::clear() {
    for (Array* array : arrays()) array->clear();
    i.clear(), j.clear();
    alike = true;
}

}  // namespace dem_min
