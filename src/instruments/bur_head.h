// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// The size of the working part of a bur, without neck and shank, mm.
struct BurHead {
    double length = 0;  ///< from the tip along the shaft; 0: unknown
    double radius = 0;  ///< the largest
    double neck = 0;    ///< radius of the neck, where the head ends
};

/// Measures the head of any bur, tool frame: it ends where the bur is no wider than its neck, seen from the shank. A
/// bur without a neck ends where its shank begins. Unknown for a surface without vertices.
[[nodiscard]] BurHead burHeadOf(const TriangleMesh& bur);

/// A disc that closes the head where the neck begins, tool frame; its face points to the shank. Empty if the head is
/// unknown.
[[nodiscard]] TriangleMesh headCap(const BurHead& head);

}  // namespace tactooth
