// SPDX-License-Identifier: MIT
#include "dem_min/simulation.hpp"

#include "dem_min/forces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace dem_min {
namespace {

// FNV-1a over 64-bit words: enough to see one changed bit.
class Hash {
  public:
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(std::uint64_t word) {
        for (int byte = 0; byte < 8; ++byte)
            state_ = (state_ ^ ((word >> (8 * byte)) & 0xff)) * 1099511628211ULL;
    }
    std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 14695981039346656037ULL;
};

// Slots by rising (i, j): an order that does not depend on how the contacts came about.
std::vector<std::size_t> canonical_order(const Contacts& c) {
    std::vector<std::size_t> order(c.count());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair{c.i[a], c.j[a]} < std::pair{c.i[b], c.j[b]};
    });
    return order;
}

void add_contacts(const Laws& laws, const Contacts& c, Ledger& sum) {
    for (const std::size_t slot : canonical_order(c)) {
        sum.elastic_normal +=
            stored_energy(laws, c, slot) - c.stored_tangential[slot] - c.stored_rolling[slot];
        sum.elastic_tangential += c.stored_tangential[slot];
        sum.elastic_rolling += c.stored_rolling[slot];
        sum.heat += heat_so_far(c, slot);
    }
}

}  // namespace

void check_finite(const Simulation& s) {
    const Particles& p = s.grains;
    for (std::size_t k = 0; k < p.count(); ++k) {
        const double sum = p.x[k] + p.y[k] + p.z[k] + p.vx[k] + p.vy[k] + p.vz[k] + p.wx[k] +
                           p.wy[k] + p.wz[k] + p.fx[k] + p.fy[k] + p.fz[k] + p.tx[k] + p.ty[k] +
                           p.tz[k];
        if (std::isfinite(sum)) continue;
        throw std::runtime_error(
            "dem_min: grain " + std::to_string(p.id[k]) + " of radius " +
            std::to_string(p.radius[k] * 1e6) + " um is not finite at step " +
            std::to_string(s.steps) + " (t = " + std::to_string(s.time()) +
            " s): the time step is too long for its contacts, or a law returned NaN");
    }
}

double Ledger::imbalance() const {
    return gravity_work + brought_in - kinetic - elastic_normal - elastic_tangential -
           elastic_rolling - heat.total() - carried_away;
}

Ledger ledger(const Simulation& s) {
    Ledger sum;
    sum.heat = s.past.heat;
    add_contacts(s.between_grains, s.pairs, sum);
    add_contacts(s.at_walls, s.wall_contacts, sum);
    double potential = 0.0;
    for (std::size_t k = 0; k < s.grains.count(); ++k)
        if (!s.grains.fixed(k)) potential += potential_of_gravity(s, k);
    sum.kinetic = kinetic_energy(s);
    sum.gravity_work = s.past.potential_in - s.past.potential_out - potential;
    sum.brought_in = s.past.kinetic_in;
    sum.carried_away = s.past.carried_away;
    return sum;
}

double kinetic_energy(const Simulation& s) {
    double sum = 0.0;
    for (std::size_t k = 0; k < s.grains.count(); ++k) sum += kinetic_energy(s.grains, k);
    return sum;
}

double translational_energy(const Simulation& s) {
    double sum = 0.0;
    for (std::size_t k = 0; k < s.grains.count(); ++k)
        if (!s.grains.fixed(k))
            sum +=
                0.5 * s.grains.mass[k] * contact::dot(s.grains.velocity(k), s.grains.velocity(k));
    return sum;
}

double mean_coordination(const Simulation& s) {
    const Particles& p = s.grains;
    std::size_t ends = 0, loose = 0;
    for (std::size_t k = 0; k < p.count(); ++k) loose += !p.fixed(k);
    for (std::size_t slot = 0; slot < s.pairs.count(); ++slot)
        ends += static_cast<std::size_t>(!p.fixed(static_cast<std::size_t>(s.pairs.i[slot]))) +
                static_cast<std::size_t>(!p.fixed(static_cast<std::size_t>(s.pairs.j[slot])));
    ends += s.wall_contacts.count();
    return loose == 0 ? 0.0 : static_cast<double>(ends) / static_cast<double>(loose);
}

std::uint64_t state_hash(const Simulation& s, double unit_of_length, double unit_of_time) {
    Hash hash;
    const auto add = [&](const std::vector<double>& values, double unit) {
        for (const double value : values) hash.add(value / unit);
    };
    const Particles& p = s.grains;
    const double unit_of_velocity = unit_of_length / unit_of_time,
                 unit_of_spin = 1.0 / unit_of_time;
    for (const auto* position : {&p.x, &p.y, &p.z}) add(*position, unit_of_length);
    for (const auto* velocity : {&p.vx, &p.vy, &p.vz}) add(*velocity, unit_of_velocity);
    for (const auto* spin : {&p.wx, &p.wy, &p.wz}) add(*spin, unit_of_spin);
    for (const auto& [contacts, laws] :
         {std::pair{&s.pairs, &s.between_grains}, {&s.wall_contacts, &s.at_walls}}) {
        const double unit_of_rolling =
            std::holds_alternative<contact::RollingSds>(laws->rolling) ? unit_of_length : 1.0;
        for (const std::size_t slot : canonical_order(*contacts)) {
            hash.add(static_cast<std::uint64_t>(contacts->i[slot]));
            hash.add(static_cast<std::uint64_t>(contacts->j[slot]));
            for (const auto* spring :
                 {&contacts->sx, &contacts->sy, &contacts->sz, &contacts->previous_radius})
                hash.add((*spring)[slot] / unit_of_length);
            for (const auto* spring : {&contacts->rx, &contacts->ry, &contacts->rz})
                hash.add((*spring)[slot] / unit_of_rolling);
            hash.add(contacts->twist[slot]);
        }
    }
    return hash.value();
}

}  // namespace dem_min
