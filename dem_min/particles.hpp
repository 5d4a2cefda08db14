// SPDX-License-Identifier: MIT
// Grains as a structure of arrays. Shape of every array: [count()]. SI doubles.
#pragma once

#include "contact/vec3.hpp"
#include "dem_min/array.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dem_min {

using contact::Vec3;

struct Grain {
    Vec3 position;       // m
    Vec3 velocity;       // m/s
    Vec3 spin;           // rad/s
    double radius;       // m
    double density;      // kg/m^3
    bool fixed = false;  // glued: never moves
    int material = 0;    // see Simulation::particular
};

struct Particles {
    Array x, y, z;     // m
    Array vx, vy, vz;  // m/s; half a step behind x while forces are evaluated
    Array wx, wy, wz;  // rad/s, likewise
    Array fx, fy, fz;  // N
    Array tx, ty, tz;  // N m
    Array radius, mass;
    Array inverse_mass, inverse_inertia;  // 0 for a fixed grain; members of bodies: see bodies.hpp
    std::vector<std::int64_t> id;         // order of birth, from 0; never reused
    std::vector<int> material;
    std::vector<int> body;  // that it is a member of; -1: none

    std::size_t count() const { return x.size(); }
    bool fixed(std::size_t k) const { return inverse_mass[k] == 0.0 && body[k] < 0; }
    bool of_one_body(std::size_t i, std::size_t j) const {
        return body[i] >= 0 && body[i] == body[j];
    }

    void add(const Grain&, std::int64_t new_id);
    // Grain k moves to new_index[k]; where that is -1 it goes. The others must fill 0, 1, 2, ... Shape: [count()].
    void renumber(const std::vector<int>& new_index);

    Vec3 position(std::size_t k) const { return {x[k], y[k], z[k]}; }
    Vec3 velocity(std::size_t k) const { return {vx[k], vy[k], vz[k]}; }
    Vec3 spin(std::size_t k) const { return {wx[k], wy[k], wz[k]}; }

    // Every array of doubles, in one order, for compaction, checkpoints and hashes.
    std::array<Array*, 19> arrays();
};

}  // namespace dem_min
