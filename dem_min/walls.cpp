// SPDX-License-Identifier: MIT
#include "dem_min/walls.hpp"

#include "dem_min/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem_min {

Wall disc(double radius, double z) { return Shell{0.0, z, radius, z}; }

Wall tube(double radius, double z_bottom, double z_top) {
    return Shell{radius, z_bottom, radius, z_top};
}

Wall cone(double radius_bottom, double z_bottom, double radius_top, double z_top) {
    return Shell{radius_bottom, z_bottom, radius_top, z_top};
}

static WallDistance distance(const Plane& plane, Vec3 point) {
    return {contact::dot(point - plane.point, plane.normal), -plane.normal};
}

static WallDistance distance(const Shell& shell, Vec3 point) {
    const double r = std::sqrt(point.x * point.x + point.y * point.y);
    const double ex = shell.r1 - shell.r0, ez = shell.z1 - shell.z0;
    const double along = ((r - shell.r0) * ex + (point.z - shell.z0) * ez) / (ex * ex + ez * ez);
    const double s = std::clamp(along, 0.0, 1.0);
    const double dr = (shell.r0 + s * ex) - r, dz = (shell.z0 + s * ez) - point.z;
    const double d = std::sqrt(dr * dr + dz * dz);
    if (d == 0.0) return {0.0, {0.0, 0.0, -1.0}};  // centre on the shell: any direction is as good
    // On the axis the radial direction is undefined and dr is 0 wherever it matters (a disc), or any direction is nearest.
    const double cx = r > 0.0 ? point.x / r : 1.0, cy = r > 0.0 ? point.y / r : 0.0;
    return {d, {dr / d * cx, dr / d * cy, dz / d}};
}

WallDistance distance(const Wall& wall, Vec3 point) {
    return std::visit([&](const auto& shape) { return distance(shape, point); }, wall);
}

double clearance(const Wall& wall, Vec3 point) {
    if (const auto* patch = std::get_if<MeshPatch>(&wall)) return clearance(*patch, point);
    return distance(wall, point).distance;
}

Vec3 velocity(const Wall& wall, Vec3 point) {
    if (const auto* plane = std::get_if<Plane>(&wall)) return plane->velocity;
    const auto* shell = std::get_if<Shell>(&wall);
    if (shell == nullptr) return {};
    if (shell->spin == 0.0) return {0.0, 0.0, shell->rise};
    return {-shell->spin * point.y, shell->spin * point.x, shell->rise};
}

Vec3 spin(const Wall& wall) {
    const auto* shell = std::get_if<Shell>(&wall);
    return shell != nullptr ? Vec3{0.0, 0.0, shell->spin} : Vec3{};
}

bool moves(const Wall& wall) {
    if (const auto* plane = std::get_if<Plane>(&wall))
        return contact::dot(plane->velocity, plane->velocity) > 0.0;
    const auto* shell = std::get_if<Shell>(&wall);
    return shell != nullptr && (shell->rise != 0.0 || shell->spin != 0.0);
}

double carry_on(Wall& wall, double time) {
    if (auto* plane = std::get_if<Plane>(&wall)) {
        plane->point = plane->point + time * plane->velocity;
        return time * contact::norm(plane->velocity);
    }
    auto& shell = std::get<Shell>(wall);
    shell.z0 += time * shell.rise, shell.z1 += time * shell.rise;
    return time * std::abs(shell.rise);
}

static Box bounds(const Plane&) {
    constexpr double far = std::numeric_limits<double>::infinity();
    return {{-far, -far, -far}, {far, far, far}};
}

static Box bounds(const Shell& shell) {
    const double r = std::max(shell.r0, shell.r1);
    return {{-r, -r, std::min(shell.z0, shell.z1)}, {r, r, std::max(shell.z0, shell.z1)}};
}

Box bounds(const Wall& wall) {
    return std::visit([](const auto& shape) { return bounds(shape); }, wall);
}

}  // namespace dem_min
