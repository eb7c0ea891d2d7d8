// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "view/camera/camera.h"
#include "view/mesh/shading_mesh.h"

namespace tactooth {

/// The visible region of one pass, in the frame of the drawn object: the six sides of its view volume and the eye.
class ClusterCuller {
public:
    /// `objectToClip` maps points of the object to OpenGL clip coordinates. `eye` is in the object's frame, with w = 0
    /// for a parallel view (then it is the direction to the eye). Clusters of back faces are skipped only if
    /// `skipBackFaces`. The drawn surface may deviate from the true one by `lodTolerance` mm for each mm of distance
    /// from the eye (in a parallel view: by `lodTolerance` mm). 0 gives the true surface.
    ClusterCuller(const Mat4& objectToClip, const Eigen::Vector4d& eye, bool skipBackFaces, double lodTolerance = 0);

    /// Whether any triangle of `cluster` may be visible. If it returns false, none is visible.
    [[nodiscard]] bool mayBeVisible(const TriangleCluster& cluster) const;

    /// The largest allowed deviation from the true surface inside this ball, mm.
    [[nodiscard]] float allowedError(const Vec3f& centre, float radius) const;

private:
    [[nodiscard]] bool isBackFacing(const TriangleCluster& cluster) const;

    std::array<Eigen::Vector4f, 6> planes_;
    Eigen::Vector4f eye_;
    bool skipBackFaces_;
    float lodTolerance_;
};

/// A range of triangles in drawing order.
struct TriangleRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    bool operator==(const TriangleRange&) const = default;
};

/// Adds the clusters that may be visible to `ranges`; adjacent ranges are merged.
void visibleRanges(const ClusterCuller& culler, std::span<const TriangleCluster> clusters,
                   std::vector<TriangleRange>& ranges);

}  // namespace tactooth
