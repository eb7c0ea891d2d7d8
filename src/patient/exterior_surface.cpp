// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/exterior_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "collision/bvh/closest_point.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

constexpr double kBall = 0.6;   // mm, radius
constexpr double kCell = 0.4;   // mm
constexpr double kReach = 2.5;  // mm, reach of the ball's centre: the depth of a fissure

/// Positions that the centre of a ball can reach from outside.
class RollingBall {
public:
    explicit RollingBall(const SurfacePart& surface) {
        const Box3& box = surface.tree().box();
        constexpr double kMargin = kBall + 2 * kCell;
        low_ = box.min().array() - kMargin;
        for (int axis = 0; axis < 3; ++axis) {
            counts_[axis] = static_cast<int>(std::ceil((box.sizes()[axis] + 2 * kMargin) / kCell)) + 1;
        }
        std::vector<std::uint8_t> isFree(static_cast<std::size_t>(counts_[0]) * counts_[1] * counts_[2]);
        parallelFor(
            isFree.size(), [&](std::size_t i) { isFree[i] = signedDistance(surface, place(i)) >= kBall; }, 64);
        flood(isFree);
    }

    /// Whether the ball comes within kReach of `point` on the side of `normal`.
    [[nodiscard]] bool reaches(const Vec3& point, const Vec3& normal) const {
        std::array<int, 3> first, last;
        for (int axis = 0; axis < 3; ++axis) {
            first[axis] = std::max(0, static_cast<int>(std::ceil((point[axis] - kReach - low_[axis]) / kCell)));
            last[axis] = std::min(counts_[axis] - 1, static_cast<int>((point[axis] + kReach - low_[axis]) / kCell));
        }
        for (int z = first[2]; z <= last[2]; ++z) {
            for (int y = first[1]; y <= last[1]; ++y) {
                for (int x = first[0]; x <= last[0]; ++x) {
                    const std::size_t i = number(x, y, z);
                    if (reached_[i] == 0) continue;
                    const Vec3 displacement = place(i) - point;
                    if (displacement.squaredNorm() < kReach * kReach && displacement.dot(normal) > 0) return true;
                }
            }
        }
        return false;
    }

private:
    void flood(const std::vector<std::uint8_t>& isFree) {
        reached_.assign(isFree.size(), 0);
        std::vector<std::size_t> front = {0};  // a corner of the grid, outside of the box
        reached_[0] = 1;
        while (!front.empty()) {
            const std::size_t here = front.back();
            front.pop_back();
            std::size_t stride = 1;
            for (int axis = 0; axis < 3; ++axis) {
                const auto count = static_cast<std::size_t>(counts_[axis]);
                const std::size_t at = here / stride % count;
                if (at > 0) visit(here - stride, isFree, front);
                if (at + 1 < count) visit(here + stride, isFree, front);
                stride *= count;
            }
        }
    }

    void visit(std::size_t cell, const std::vector<std::uint8_t>& isFree, std::vector<std::size_t>& front) {
        if (isFree[cell] == 0 || reached_[cell] != 0) return;
        reached_[cell] = 1;
        front.push_back(cell);
    }

    [[nodiscard]] std::size_t number(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * counts_[1] + y) * counts_[0] + x;
    }
    [[nodiscard]] Vec3 place(std::size_t i) const {
        const auto x = static_cast<std::size_t>(counts_[0]), y = static_cast<std::size_t>(counts_[1]);
        return low_ + kCell * Vec3(static_cast<double>(i % x), static_cast<double>(i / x % y),
                                   static_cast<double>(i / (x * y)));
    }

    Vec3 low_;
    std::array<int, 3> counts_{};
    std::vector<std::uint8_t> reached_;
};

}  // namespace

ExteriorSurface exteriorSurface(const SurfacePart& surface) {
    const RollingBall ball(surface);
    const TriangleMesh& mesh = surface.mesh();
    std::vector<std::uint8_t> isOutside(mesh.triangles.size());
    parallelFor(
        isOutside.size(),
        [&](std::size_t t) {
            const Vec3 centre = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
            isOutside[t] = ball.reaches(centre, mesh.areaVector(t));
        },
        64);
    ExteriorSurface result;
    result.exterior.vertices = mesh.vertices;
    for (std::size_t t = 0; t < isOutside.size(); ++t) {
        if (isOutside[t] != 0) {
            result.exterior.triangles.push_back(mesh.triangles[t]);
        } else {
            result.pulpWallArea += mesh.areaVector(t).norm() / 2;
        }
    }
    return result;
}

}  // namespace tactooth
