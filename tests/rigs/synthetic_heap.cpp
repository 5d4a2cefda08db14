// SPDX-License-Identifier: MIT
#include "synthetic_heap.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace synthetic {
namespace {

constexpr double hollow = std::numbers::sqrt2 / 2.0 -
                          0.5;  // m, centre of a grain lying on four glued ones, a square 1 m wide
constexpr double slab =
    0.7;  // m, thinnest layer of centres: most cuts of the lattice then have no gap

struct Rotation {
    contact::Vec3 row[3];
};

// A rotation drawn evenly: the unit quaternion of four normal numbers.
Rotation random_rotation(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    double a = normal(random), b = normal(random), c = normal(random), d = normal(random);
    const double n = std::sqrt(a * a + b * b + c * c + d * d);
    a /= n, b /= n, c /= n, d /= n;
    return {{{1.0 - 2.0 * (c * c + d * d), 2.0 * (b * c - a * d), 2.0 * (b * d + a * c)},
             {2.0 * (b * c + a * d), 1.0 - 2.0 * (b * b + d * d), 2.0 * (c * d - a * b)},
             {2.0 * (b * d - a * c), 2.0 * (c * d + a * b), 1.0 - 2.0 * (b * b + c * c)}}};
}

}  // namespace

rigs::Heap heap(const Shape& shape, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    const Rotation turn = random_rotation(random);
    const contact::Vec3 shift{uniform(random), uniform(random), uniform(random)};
    const double r = shape.base_radius, reach = std::hypot(r, shape.lift(0.0, 0.0)) + 4.0;
    // A simple cubic lattice is that of the integers; those with an even sum make a face-centred one, sqrt 2 apart.
    const double step = shape.simple_cubic ? 1.0 : 1.0 / std::numbers::sqrt2;
    const auto cells = static_cast<long>(reach / step) + 1;
    rigs::Heap made{{}, {}, r};
    for (long i = -cells; i <= cells; ++i) {
        for (long j = -cells; j <= cells; ++j) {
            for (long k = -cells; k <= cells; ++k) {
                if (!shape.simple_cubic && (i + j + k) % 2 != 0) continue;
                const contact::Vec3 l{step * (static_cast<double>(i) + shift.x),
                                      step * (static_cast<double>(j) + shift.y),
                                      step * (static_cast<double>(k) + shift.z)};
                const contact::Vec3 p{dot(turn.row[0], l), dot(turn.row[1], l),
                                      dot(turn.row[2], l)};
                const double top = shape.lift(p.x, p.y);
                if (top < 0.0 || p.z < 0.0 || p.z > top + slab || p.z < top + slab - shape.shell) {
                    continue;
                }
                if (std::hypot(p.x, p.y) > r) continue;
                const contact::Vec3 scatter{shape.noise * normal(random),
                                            shape.noise * normal(random),
                                            shape.noise * normal(random)};
                made.centre.push_back(p + scatter + contact::Vec3{0.0, 0.0, hollow});
                made.radius.push_back(0.5);
            }
        }
    }
    return made;
}

Shape cone(double base_radius, double tangent) {
    return {base_radius, [base_radius, tangent](double x, double y) {
                return tangent * (base_radius - std::hypot(x, y));
            }};
}

}  // namespace synthetic
