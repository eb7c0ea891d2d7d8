// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// The reflecting disc of a mirror: a plane reflection clipped to a circle.
struct MirrorDisc {
    Vec3 centre = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();  ///< unit, out of the glass
    double radius = 0;            ///< mm
};

/// A dental mouth mirror. Frame: origin at the centre of the glass, +z out of it; stem and handle leave toward +x, 45
/// degrees behind the glass. mm.
struct DentalMirror {
    TriangleMesh surface;  ///< head, stem with handle, and glass: three closed bodies with small gaps between them
    std::size_t glassBegin = 0;  ///< the glass is the triangles [glassBegin, surface.triangles.size())
    MirrorDisc disc;             ///< its face as an exact disc
};

/// mm: diameters of the heads that can be made.
inline constexpr double kSmallestMirror = 10, kLargestMirror = 40;

/// `headDiameter`: of the whole head with its rim, mm (22 is a No. 4, 24 a No. 5, 18 a No. 2).
[[nodiscard]] DentalMirror makeMirror(double headDiameter = 22);

/// Diameter of the head whose disc has this radius, mm.
[[nodiscard]] double mirrorHeadOf(double discRadius);

}  // namespace tactooth
