// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A soft tissue as it is drawn. Three tissues follow each other over its surface.
struct ZonedMesh {
    TriangleMesh mesh;
    /// Of each vertex: 0 the first tissue, kSecond the second, kThird the third, and between them where one passes
    /// into the next.
    std::vector<std::uint8_t> zones;
    static constexpr std::uint8_t kSecond = 127, kThird = 254;

    /// The zone of a place: `share` is 0 at the first tissue, 1 at the second, 2 at the third; beyond this range it is
    /// that of the nearest.
    [[nodiscard]] static std::uint8_t zoneOf(double share);
};

}  // namespace tactooth
