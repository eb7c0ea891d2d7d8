// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/cluster_culling.h"

#include <algorithm>

namespace tactooth {

ClusterCuller::ClusterCuller(const Mat4& objectToClip, const Eigen::Vector4d& eye, bool skipBackFaces,
                             double lodTolerance)
    : eye_(eye.cast<float>()), skipBackFaces_(skipBackFaces), lodTolerance_(static_cast<float>(lodTolerance)) {
    // A point is inside where -w <= x, y, z <= w in clip coordinates. Each bound is a linear combination of matrix
    // rows. G. Gribb, K. Hartmann, Fast extraction of viewing frustum planes from the world-view-projection matrix,
    // 2001.
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            const double sign = side == 0 ? 1.0 : -1.0;
            const Eigen::Vector4d plane = (objectToClip.row(3) + sign * objectToClip.row(axis)).transpose();
            planes_[static_cast<std::size_t>(2 * axis + side)] = (plane / plane.head<3>().norm()).cast<float>();
        }
    }
}

bool ClusterCuller::mayBeVisible(const TriangleCluster& cluster) const {
    for (const Eigen::Vector4f& side : planes_) {
        if (side.head<3>().dot(cluster.centre) + side.w() < -cluster.radius) return false;
    }
    return !skipBackFaces_ || !isBackFacing(cluster);
}

float ClusterCuller::allowedError(const Vec3f& centre, float radius) const {
    if (eye_.w() == 0) return lodTolerance_;
    return lodTolerance_ * std::max(0.0F, (centre - eye_.head<3>()).norm() - radius);
}

bool ClusterCuller::isBackFacing(const TriangleCluster& cluster) const {
    if (cluster.coneSine > 1) return false;
    // Every facet normal is within asin(coneSine) of the axis. The direction from any point of the ball to the eye is
    // within asin(radius / distance) of the direction from its centre. All facets are back faces if the angle between
    // the axis and the direction *from* the eye is less than 90 degrees minus both angles.
    const Vec3f fromEye = eye_.w() == 0 ? Vec3f(-eye_.head<3>()) : Vec3f(cluster.centre - eye_.head<3>());
    const float distance = fromEye.norm();
    const float spread = eye_.w() == 0 ? 0.0F : cluster.radius / distance;
    if (spread >= 1) return false;
    const float coneCosine = std::sqrt(1 - cluster.coneSine * cluster.coneSine);
    const float spreadCosine = std::sqrt(1 - spread * spread);
    const float sineOfSum = cluster.coneSine * spreadCosine + coneCosine * spread;
    const bool sumBelowRightAngle = coneCosine * spreadCosine > cluster.coneSine * spread;
    return sumBelowRightAngle && cluster.axis.dot(fromEye) > sineOfSum * distance;
}

void visibleRanges(const ClusterCuller& culler, std::span<const TriangleCluster> clusters,
                   std::vector<TriangleRange>& ranges) {
    for (const TriangleCluster& cluster : clusters) {
        if (!culler.mayBeVisible(cluster)) continue;
        if (!ranges.empty() && ranges.back().first + ranges.back().count == cluster.firstTriangle) {
            ranges.back().count += cluster.triangles;
        } else {
            ranges.push_back({cluster.firstTriangle, cluster.triangles});
        }
    }
}

}  // namespace tactooth
