// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "collision/narrow/triangle3.h"

namespace tactooth {

/// Two features of a tooth's and a tool's triangle that one of them stands over the other with: a corner over a face, a
/// face over a corner, or two edges that cross; or a corner over a plane in front of the tooth's triangle.
struct FeaturePair {
    enum class Kind { CornerOverFace, FaceOverCorner, EdgeOverEdge, CornerOverPlane };
    Kind kind = Kind::CornerOverPlane;
    int tooth = 0;  ///< corner, or the edge that begins at it; 0 for a face or a plane
    int tool = 0;

    friend bool operator==(const FeaturePair&, const FeaturePair&) = default;
};

/// How far apart two features are, and where.
struct FeatureGap {
    double gap;   ///< along `normal`; negative where the tool's stands behind the tooth's, mm
    Vec3 normal;  ///< unit, from the tooth's feature to the tool's
    Vec3 point;   ///< where the one presses on the other: its place in space is what matters to a turn
};

/// The features by which the two triangles could meet if the tool's came down along -`up` (unit): at most 3 corners, 3
/// corners and 9 crossings, which between them say whether the one is above the other.
struct ContactFeatures {
    std::array<FeaturePair, 15> pairs;
    int count = 0;

    ContactFeatures(const Triangle3& tooth, const Triangle3& tool, const Vec3& up);
};

/// The gap of two features along the normal that belongs to them, on the side of `up`. None where they have no normal:
/// a triangle without area, parallel edges, a plane.
[[nodiscard]] std::optional<FeatureGap> gapBetween(const FeaturePair& pair, const Triangle3& tooth,
                                                   const Triangle3& tool, const Vec3& up);

}  // namespace tactooth
