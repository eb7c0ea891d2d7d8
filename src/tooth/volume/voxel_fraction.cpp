// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/voxel_fraction.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"

// Source: R. Scardovelli, S. Zaleski, "Analytical Relations Connecting Linear Interfaces and Volume Fractions in
// Rectangular Grids", J. Comput. Phys. 164, 2000. Differences: small components of a normal are raised, so that one
// closed form serves all cases. For two half-spaces the cube is sliced, and the fractions of each slice are multiplied.

namespace tactooth {
namespace {

/// Smaller components of a normal are raised to this, since the closed form divides by their product.
constexpr double kLeastComponent = 1e-3;
/// Slices along a side for the fraction within two half-spaces.
constexpr int kSlices = 4;

double cubed(double value) { return value > 0 ? value * value * value : 0; }

/// Volume of {x in [0,1]^3 : m . x < alpha} for positive m.
double corneredVolume(const Vec3& m, double alpha) {
    TACTOOTH_ASSERT(m.minCoeff() > 0);
    const double sum = m.x() + m.y() + m.z();
    double volume = cubed(alpha) - cubed(alpha - sum);
    for (int axis = 0; axis < 3; ++axis) {
        volume += cubed(alpha - sum + m[axis]) - cubed(alpha - m[axis]);
    }
    return std::clamp(volume / (6 * (m.x() * m.y() * m.z())), 0.0, 1.0);
}

/// The middles of a row of slices, from the middle of the cube.
struct Slices {
    static_assert(kSlices == 4);
    Eigen::Array4d x{-0.375, -0.125, 0.125, 0.375};
    double y, z;
    Slices(int row, int layer) : y(x[row]), z(x[layer]) {}
};

Eigen::Array4d cubed(const Eigen::Array4d& values) {
    const Eigen::Array4d positive = values.max(0.0);
    return positive * positive * positive;
}

}  // namespace

// The same operations in the same order as for one half-space, so that a node's fraction does not depend on the nodes
// beside it.
Eigen::Array4d cubeFractions(const Eigen::Array4d& distances, const std::array<Eigen::Array4d, 3>& absNormals) {
    TACTOOTH_ASSERT(distances.allFinite());
    TACTOOTH_ASSERT((absNormals[0] >= 0 && absNormals[1] >= 0 && absNormals[2] >= 0).all());
    std::array<Eigen::Array4d, 3> m;
    for (int axis = 0; axis < 3; ++axis) m[axis] = absNormals[axis].max(kLeastComponent);
    const Eigen::Array4d sum = m[0] + m[1] + m[2];
    const Eigen::Array4d reach = 0.5 * sum;
    const Eigen::Array4d alpha = reach - distances;
    Eigen::Array4d volume = cubed(alpha) - cubed(alpha - sum);
    for (int axis = 0; axis < 3; ++axis) volume += cubed(alpha - sum + m[axis]) - cubed(alpha - m[axis]);
    const Eigen::Array4d share = (volume / (6 * (m[0] * m[1] * m[2]))).max(0.0).min(1.0);
    return (distances >= reach).select(0.0, (distances <= -reach).select(1.0, share));
}

double cubeFraction(const HalfSpace& half) {
    TACTOOTH_ASSERT(!std::isnan(half.distance));
    TACTOOTH_ASSERT(std::abs(half.normal.squaredNorm() - 1) < 1e-6);
    const Vec3 m = half.normal.cwiseAbs().cwiseMax(kLeastComponent);
    const double reach = 0.5 * (m.x() + m.y() + m.z());
    if (half.distance >= reach) return 0;
    if (half.distance <= -reach) return 1;
    return corneredVolume(m, reach - half.distance);
}

double cubeFraction(const HalfSpace& first, const HalfSpace& second) {
    const double one = cubeFraction(first);
    const double two = cubeFraction(second);
    if (one == 0 || two == 0) return 0;
    if (one == 1) return two;
    if (two == 1) return one;
    const auto fractionOfSlices = [](const HalfSpace& half, const Slices& at) -> Eigen::Array4d {
        const Eigen::Array4d distances =
            half.distance + half.normal.x() * at.x + half.normal.y() * at.y + half.normal.z() * at.z;
        return (0.5 - distances * kSlices).max(0.0).min(1.0);
    };
    Eigen::Array4d total = Eigen::Array4d::Zero();
    for (int z = 0; z < kSlices; ++z) {
        for (int y = 0; y < kSlices; ++y) {
            const Slices row(y, z);
            total += fractionOfSlices(first, row) * fractionOfSlices(second, row);
        }
    }
    TACTOOTH_ASSERT(total.sum() >= 0 && total.sum() <= kSlices * kSlices * kSlices);
    return total.sum() / (kSlices * kSlices * kSlices);
}

}  // namespace tactooth
