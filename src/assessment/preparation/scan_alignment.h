// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/surface.h"
#include "geometry/util/pose.h"

namespace tactooth {

/// How well a surface lies on the uncut tooth, by those of its points that are not prepared.
struct ScanFit {
    double residual = 0;   ///< RMS distance of these points, mm
    double usedShare = 0;  ///< of all points, 0..1

    /// Whether the two are the same tooth in the same place: the RMS is at most 0.05 mm, of a share that is enough.
    [[nodiscard]] bool isGood() const;
};
inline constexpr double kMostResidual = 0.05;  ///< mm: scanners differ by 0.005 to 0.013 mm from each other

/// As the surface lies. `original`: closed.
[[nodiscard]] ScanFit fitOf(const TriangleMesh& scan, const SurfacePart& original);

struct ScanAlignment {
    Pose scanInTooth;
    ScanFit fit;  ///< after it
};

/// Lays a scan on the uncut tooth, from a place within a few mm and some ten degrees: iterated closest points (Besl &
/// McKay 1992) by distances to planes (Chen & Medioni 1991), trimmed (Chetverikov et al. 2002) so that the prepared
/// part does not count.
[[nodiscard]] ScanAlignment alignScan(const TriangleMesh& scan, const SurfacePart& original);

}  // namespace tactooth
