// SPDX-License-Identifier: MIT
#include "dem_min/simulation.hpp"

#include "dem_min/forces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>

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

template <class T, class Allocator>
std::size_t bytes(const std::vector<T, Allocator>& array) {
    return array.size() * sizeof(T);
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
    return gravity_work + wall_work + shaking_work + brought_in - kinetic - elastic_normal -
           elastic_tangential - elastic_rolling - heat.total() - carried_away;
}

Ledger ledger(const Simulation& s) {
    Ledger sum;
    sum.heat = s.past.heat;
    sum.wall_work = s.past.wall_work;
    sum.shaking_work = s.past.shaking_work;
    for (const Tile& tile : s.tiles) sum.heat += tile.ended, sum.wall_work += tile.wall_work;
    for_each_contact(s, [&](std::size_t group, const Contacts& c, std::size_t slot) {
        const double tangential = c.books.stored_tangential[slot];
        const double rolling = c.books.stored_rolling[slot];
        sum.elastic_normal += stored_energy(s.laws(group), c, slot) - tangential - rolling;
        sum.elastic_tangential += tangential;
        sum.elastic_rolling += rolling;
        sum.heat += heat_so_far(c, slot);
    });
    double potential = 0.0;
    for (std::size_t k = 0; k < s.grains.count(); ++k)
        if (!s.grains.fixed(k)) potential += potential_of_gravity(s, k);
    for (const Body& body : s.bodies) potential += potential_of_gravity(s, body);
    sum.kinetic = kinetic_energy(s);
    sum.gravity_work = s.past.potential_in - s.past.potential_out - potential;
    sum.brought_in = s.past.kinetic_in;
    sum.carried_away = s.past.carried_away;
    return sum;
}

double kinetic_energy(const Simulation& s) {
    double sum = 0.0;
    for (std::size_t k = 0; k < s.grains.count(); ++k) sum += kinetic_energy(s.grains, k);
    for (const Body& body : s.bodies) sum += kinetic_energy(body);
    return sum;
}

double translational_energy(const Simulation& s) {
    double sum = 0.0;
    for (std::size_t k = 0; k < s.grains.count(); ++k)
        if (!s.grains.fixed(k))
            sum +=
                0.5 * s.grains.mass[k] * contact::dot(s.grains.velocity(k), s.grains.velocity(k));
    for (const Body& body : s.bodies)
        sum += 0.5 * body.mass * contact::dot(body.velocity, body.velocity);
    return sum;
}

std::size_t pair_count(const Simulation& s) {
    std::size_t count = 0;
    for (const Tile& tile : s.tiles)
        for (std::size_t group = 0; group < tile.groups.size(); ++group)
            if (!s.at_wall(group)) count += tile.groups[group].count();
    return count;
}

std::size_t wall_contact_count(const Simulation& s) {
    std::size_t count = 0;
    for (const Tile& tile : s.tiles) count += tile.contacts();
    return count - pair_count(s);
}

std::size_t loose_count(const Simulation& s) {
    std::size_t loose = s.bodies.size();
    for (std::size_t k = 0; k < s.grains.count(); ++k)
        loose += !s.grains.fixed(k) && s.grains.body[k] < 0;
    return loose;
}

double mean_coordination(const Simulation& s) {
    const Particles& p = s.grains;
    std::size_t ends = 0;
    const auto is_loose = [&](int k) {
        return static_cast<std::size_t>(!p.fixed(static_cast<std::size_t>(k)));
    };
    for_each_contact(s, [&](std::size_t group, const Contacts& c, std::size_t slot) {
        ends += is_loose(c.i[slot]) + (s.at_wall(group) ? 0 : is_loose(c.j[slot]));
    });
    const std::size_t loose = loose_count(s);
    return loose == 0 ? 0.0 : static_cast<double>(ends) / static_cast<double>(loose);
}

double largest_overlap(const Simulation& s) {
    double largest = 0.0;
    for_each_contact(s, [&](std::size_t group, const Contacts& c, std::size_t slot) {
        const auto i = static_cast<std::size_t>(c.i[slot]), j = static_cast<std::size_t>(c.j[slot]);
        const double overlap =
            s.at_wall(group)
                ? s.grains.radius[i] - distance(s.walls[j], s.grains.position(i)).distance
                : s.grains.radius[i] + s.grains.radius[j] - contact::norm(apart(s, i, j));
        largest = std::max(largest, overlap / c.r_star[slot]);
    });
    return largest;
}

double mean_compression(const Simulation& s) {
    double sum = 0.0;
    std::size_t contacts = 0;
    for_each_contact(s, [&](std::size_t group, const Contacts& c, std::size_t slot) {
        if (s.at_wall(group)) return;
        const auto i = static_cast<std::size_t>(c.i[slot]), j = static_cast<std::size_t>(c.j[slot]);
        const double overlap =
            s.grains.radius[i] + s.grains.radius[j] - contact::norm(apart(s, i, j));
        sum += std::max(0.0,
                        std::visit(
                            [&](const auto& law) {
                                return law.at(c.r_star[slot], c.length_scale[slot], overlap).force;
                            },
                            s.laws(group).normal));
        ++contacts;
    });
    return contacts == 0 ? 0.0 : sum / static_cast<double>(contacts);
}

MemoryUse memory_use(const Simulation& s) {
    MemoryUse use{};
    Particles grains = s.grains;
    for (const Array* array : grains.arrays()) use.bytes_grains += bytes(*array);
    use.bytes_grains += bytes(s.grains.id) + bytes(s.grains.material) + bytes(s.grains.body) +
                        bytes(s.bodies) + bytes(s.members);
    for (const Tile& tile : s.tiles) {
        for (const Contacts& c : tile.groups) {
            for (const Array* array : c.arrays()) use.bytes_contacts += bytes(*array);
            use.bytes_contacts += bytes(c.i) + bytes(c.j);
        }
        for (const Candidates* near : {&tile.near_grains, &tile.near_walls})
            use.bytes_lists += bytes(near->i) + bytes(near->j) + bytes(near->due);
        use.bytes_lists +=
            bytes(tile.outbox.loads) + bytes(tile.outbox.to) + bytes(tile.inbox) + sizeof(Tile);
    }
    for (const Spare& spare : s.spare) {
        for (const auto& piece : spare.loads) use.bytes_lists += bytes(piece);
        for (const auto& piece : spare.outboxes) use.bytes_lists += bytes(piece);
    }
    return use;
}

std::size_t bytes_moved(const Simulation& s) {
    constexpr std::size_t number = sizeof(double), index = sizeof(int);
    constexpr std::size_t motion = 9, inertias = 3;  // x, v and w; m, 1/m and 1/I
    std::size_t sum = s.grains.count() * number * (2 * motion + inertias);
    for_each_contact(s, [&](std::size_t group, const Contacts& c, std::size_t) {
        const std::size_t twist = s.laws(group).twisting.g_star > 0.0 ? 1 : 0;
        constexpr std::size_t history = 7;  // both springs and the contact radius
        const std::size_t constants = c.alike ? 0 : 3;
        sum += 2 * index + number * (2 * (history + twist) + constants);
    });
    for (const Tile& tile : s.tiles) {
        sum += number * (tile.near_grains.count() + tile.near_walls.count());  // when they are due
        sum += bytes(tile.inbox);
    }
    return sum;
}

std::uint64_t state_hash(const Simulation& s, double unit_of_length, double unit_of_time) {
    Hash hash;
    const auto add = [&](const Array& values, double unit) {
        for (const double value : values) hash.add(value / unit);
    };
    const Particles& p = s.grains;
    const double unit_of_velocity = unit_of_length / unit_of_time,
                 unit_of_spin = 1.0 / unit_of_time;
    for (const auto* position : {&p.x, &p.y, &p.z}) add(*position, unit_of_length);
    for (const auto* velocity : {&p.vx, &p.vy, &p.vz}) add(*velocity, unit_of_velocity);
    for (const auto* spin : {&p.wx, &p.wy, &p.wz}) add(*spin, unit_of_spin);
    for (const Body& body : s.bodies) {
        const Quaternion& q = body.turn;
        for (const double part : {q.w, q.x, q.y, q.z}) hash.add(part);
        for (const double part : {body.centre.x, body.centre.y, body.centre.z})
            hash.add(part / unit_of_length);
        for (const double part : {body.velocity.x, body.velocity.y, body.velocity.z})
            hash.add(part / unit_of_velocity);
    }
    for_each_contact(s, [&](std::size_t group, const Contacts& c, std::size_t slot) {
        const double unit_of_rolling =
            std::holds_alternative<contact::RollingSds>(s.laws(group).rolling) ? unit_of_length
                                                                               : 1.0;
        hash.add(static_cast<std::uint64_t>(c.i[slot]));
        hash.add(static_cast<std::uint64_t>(c.j[slot]));
        for (const auto* spring : {&c.sx, &c.sy, &c.sz, &c.previous_radius})
            hash.add((*spring)[slot] / unit_of_length);
        for (const auto* spring : {&c.rx, &c.ry, &c.rz})
            hash.add((*spring)[slot] / unit_of_rolling);
        hash.add(c.twist[slot]);
        if (!c.age.empty()) hash.add(c.age[slot] / unit_of_time);
    });
    return hash.value();
}

}  // namespace dem_min
