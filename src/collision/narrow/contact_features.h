// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "collision/narrow/triangle3.h"

namespace tactooth {

/// A feature of a tooth's triangle and one of a tool's triangle that can touch: a corner over a face, a face over a
/// corner, or two edges that cross; or a corner of the tool over a plane in front of the tooth's triangle.
struct FeaturePair {
    enum class Kind { CornerOverFace, FaceOverCorner, EdgeOverEdge, CornerOverPlane };
    Kind kind = Kind::CornerOverPlane;
    int tooth = 0;  ///< corner, or the edge that begins at it; 0 for a face or a plane
    int tool = 0;

    friend bool operator==(const FeaturePair&, const FeaturePair&) = default;
};

/// How far apart two features are, and where.
struct FeatureGap {
    double gap;   ///< along `normal`, mm; negative: the tool's feature is behind the tooth's
    Vec3 normal;  ///< unit, from the tooth's feature to the tool's
    Vec3 point;   ///< where the two features would touch: the lever of a rotation, mm
};

/// The features by which two triangles could meet if the tool's triangle moved along -`up` (unit): at most 3 corners of
/// each triangle and 9 pairs of edges. There are none if the triangles do not overlap in a projection along `up`.
struct ContactFeatures {
    std::array<FeaturePair, 15> pairs;
    int count = 0;

    ContactFeatures(const Triangle3& tooth, const Triangle3& tool, const Vec3& up);
};

/// The gap of two features along their own normal, on the side of `up` (unit). None if they have no normal: a triangle
/// without area, parallel edges, a plane.
[[nodiscard]] std::optional<FeatureGap> gapBetween(const FeaturePair& pair, const Triangle3& tooth,
                                                   const Triangle3& tool, const Vec3& up);

}  // namespace tactooth
