// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "geometry/util/pose.h"
#include "instruments/anatomy/tooth_shape.h"
#include "instruments/mouth/arch_curve.h"

namespace tactooth {

inline constexpr int kTeethPerQuadrant = 8;  ///< in one jaw

/// The shape of a tooth and its pose: the frame of the shape (+x mesial) in the mouth.
struct PlacedShape {
    ToothShape shape;
    Pose shapeInMouth;
};

/// The closest point between two neighbours; of central incisors, which touch along a line, its middle.
struct ProximalContact {
    Vec3 point = Vec3::Zero();  ///< mouth frame
    double gap = 0;             ///< mm
};

/// One side of one jaw, teeth from the central incisor to the third molar. The upper jaw's right side and the lower
/// jaw's left side, as the shapes of both have +x mesial; the other sides are their mirror images.
struct JawQuadrant {
    bool upper = false;
    std::array<PlacedShape, kTeethPerQuadrant> teeth;
    /// Between each tooth and the one before it; the first one touches its mirror image.
    std::array<ProximalContact, kTeethPerQuadrant> contacts;
};

struct ToothArrangement {
    ArchCurve line;
    JawQuadrant upper, lower;
};

// Gaps between neighbours, and between a tooth and its opponents, as the gap of meshes that approximate the teeth; the
// surfaces themselves may be 0.02 mm closer. Floss of 0.05 mm passes.
inline constexpr double kContactGap = 0.05;   ///< mm
inline constexpr double kOcclusalGap = 0.06;  ///< mm

/// The poses of all teeth of a closed mouth: neighbours touch, and each upper tooth is in occlusion with the lower
/// ones.
[[nodiscard]] ToothArrangement arrangeTeeth(std::uint32_t seed);

/// The mirror image of a pose in the plane x = 0, for bodies that are themselves mirrored in x.
[[nodiscard]] Pose mirroredInX(const Pose& pose);

}  // namespace tactooth
