// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// E. Catmull, R. Rom, "A class of local interpolating splines", in Computer Aided Geometric Design (1974). The rings of
// a tube do not twist: the first direction of each ring is that of the ring before, rotated by the bend only.
#include "instruments/modelling/tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

Vec3 directionAt(std::span<const TubePoint> points, std::size_t i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, points.size() - 1);
    return (points[after].centre - points[before].centre).normalized();
}

void addRing(TriangleMesh& mesh, const TubePoint& point, const Vec3& along, const Vec3& first, int sides) {
    const Vec3 second = along.cross(first);
    for (int side = 0; side < sides; ++side) {
        const double angle = 2 * std::numbers::pi * side / sides;
        const Vec3 out = std::cos(angle) * first + std::sin(angle) * second;
        mesh.vertices.push_back((point.centre + point.radius * out).cast<float>());
    }
}

}  // namespace

TriangleMesh tube(std::span<const TubePoint> points, int sides) {
    TACTOOTH_ASSERT(points.size() >= 2 && sides >= 3);
    TriangleMesh mesh;
    Vec3 first = directionAt(points, 0).unitOrthogonal();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 along = directionAt(points, i);
        first = (first - first.dot(along) * along).normalized();
        addRing(mesh, points[i], along, first, sides);
    }
    const auto bottom = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(points.front().centre.cast<float>());
    mesh.vertices.push_back(points.back().centre.cast<float>());
    const auto at = [&](std::size_t ring, int side) { return static_cast<std::uint32_t>(ring * sides + side % sides); };
    const std::size_t last = points.size() - 1;
    for (int side = 0; side < sides; ++side) {
        mesh.triangles.push_back({bottom, at(0, side + 1), at(0, side)});
        for (std::size_t ring = 0; ring < last; ++ring) {
            mesh.triangles.push_back({at(ring, side), at(ring, side + 1), at(ring + 1, side + 1)});
            mesh.triangles.push_back({at(ring, side), at(ring + 1, side + 1), at(ring + 1, side)});
        }
        mesh.triangles.push_back({bottom + 1, at(last, side), at(last, side + 1)});
    }
    return mesh;
}

std::vector<TubePoint> smoothed(std::span<const TubePoint> points, int steps) {
    TACTOOTH_ASSERT(points.size() >= 2 && steps >= 1);
    std::vector<TubePoint> result;
    const auto centre = [&](std::ptrdiff_t i) -> Vec3 {
        return points[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, std::ssize(points) - 1))].centre;
    };
    for (std::ptrdiff_t i = 0; i + 1 < std::ssize(points); ++i) {
        const Vec3 a = centre(i - 1), b = centre(i), c = centre(i + 1), d = centre(i + 2);
        for (int step = 0; step < steps; ++step) {
            const double t = static_cast<double>(step) / steps;
            const Vec3 at =
                0.5 * (2 * b + t * (c - a) + t * t * (2 * a - 5 * b + 4 * c - d) + t * t * t * (3 * b - 3 * c + d - a));
            result.push_back({at, std::lerp(points[static_cast<std::size_t>(i)].radius,
                                            points[static_cast<std::size_t>(i + 1)].radius, t)});
        }
    }
    result.push_back(points.back());
    return result;
}

}  // namespace tactooth
