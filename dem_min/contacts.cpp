// SPDX-License-Identifier: MIT
#include "dem_min/contacts.hpp"

#include <algorithm>
#include <tuple>

namespace dem_min {
namespace {

auto state_of(auto& c) {
    return std::array{&c.r_star, &c.m_star, &c.length_scale,   &c.sx, &c.sy, &c.sz, &c.rx, &c.ry,
                      &c.rz,     &c.twist,  &c.previous_radius};
}

auto books_of(auto& c) {
    auto& b = c.books;
    return std::array{&b.overlap,
                      &b.nx,
                      &b.ny,
                      &b.nz,
                      &b.dashpot,
                      &b.fx,
                      &b.fy,
                      &b.fz,
                      &b.tix,
                      &b.tiy,
                      &b.tiz,
                      &b.tjx,
                      &b.tjy,
                      &b.tjz,
                      &b.heat_normal,
                      &b.heat_tangential,
                      &b.heat_rolling,
                      &b.heat_tear_off,
                      &b.stored_tangential,
                      &b.stored_rolling};
}

bool has_books(const Contacts& c) { return c.books.nx.size() == c.count() && c.count() > 0; }

}  // namespace

Dissipation& Dissipation::operator+=(const Dissipation& other) {
    normal_dashpot += other.normal_dashpot;
    tangential += other.tangential;
    rolling += other.rolling;
    tear_off += other.tear_off;
    drag += other.drag;
    return *this;
}

namespace {

template <class All>
All all_arrays(auto& contacts) {
    const auto state = state_of(contacts);
    const auto books = books_of(contacts);
    static_assert(state.size() + 1 + books.size() == std::tuple_size_v<All>);
    All all;
    auto next = std::copy(state.begin(), state.end(), all.begin());
    *next = &contacts.age;
    std::copy(books.begin(), books.end(), next + 1);
    return all;
}

}  // namespace

std::array<Array*, 32> Contacts::arrays() { return all_arrays<std::array<Array*, 32>>(*this); }

std::array<const Array*, 32> Contacts::arrays() const {
    return all_arrays<std::array<const Array*, 32>>(*this);
}

void Contacts::add(int grain_i, int partner_j, const ContactConstants& constants, bool with_books,
                   bool singly) {
    if (count() == 0) alike = true, common = constants;
    alike = alike && constants == common && !singly;
    for (Array* array : state_of(*this)) array->push_back(0.0);
    if (with_books)
        for (Array* array : books_of(*this)) array->push_back(0.0);
    if (singly) age.push_back(0.0);
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
    const auto take_last = [slot](Array* array) {
        (*array)[slot] = array->back();
        array->pop_back();
    };
    if (has_books(*this)) std::ranges::for_each(books_of(*this), take_last);
    std::ranges::for_each(state_of(*this), take_last);
    if (!age.empty()) take_last(&age);
    i[slot] = i.back(), i.pop_back();
    j[slot] = j.back(), j.pop_back();
}

void Contacts::clear() {
    for (Array* array : arrays()) array->clear();
    i.clear(), j.clear();
    alike = true;
}

}  // namespace dem_min
