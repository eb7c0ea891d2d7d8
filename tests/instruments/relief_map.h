// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth::test {

/// The side of a mesh that faces along an axis, as heights over a grid of 0.08 mm.
class ReliefMap {
public:
    /// The highest places along `axis` (0 to 2), or with `sign` -1 the lowest, over the other two axes `u` and `v`.
    ReliefMap(const TriangleMesh& mesh, int u, int v, int axis, double sign = 1);

    /// The coordinate along the axis there; none beside the mesh.
    [[nodiscard]] std::optional<double> at(double u, double v) const;

    [[nodiscard]] const Eigen::AlignedBox2d& box() const { return box_; }

    static constexpr double kCell = 0.08;  ///< mm

private:
    void add(const Vec3& a, const Vec3& b, const Vec3& c);
    [[nodiscard]] std::size_t cellOf(int i, int j) const { return static_cast<std::size_t>(j * columns_ + i); }

    Eigen::AlignedBox2d box_;
    double sign_;
    int columns_ = 0, rows_ = 0;
    std::vector<double> heights_;  ///< times `sign_`; minus infinity beside the mesh
};

/// Root mean square of the difference of two reliefs in a box, after the best paraboloid is taken off; mm.
[[nodiscard]] double reliefDifference(const ReliefMap& a, const ReliefMap& b, const Eigen::AlignedBox2d& where);

/// Correlation of a relief with its mirror image in `u`, about the middle of the map: 1 for a symmetric one. Only the
/// places with `v` from `from` to `to` count. A paraboloid is taken off first, so that the general bulge does not.
[[nodiscard]] double mirrorCorrelation(const ReliefMap& map, double from, double to);

}  // namespace tactooth::test
