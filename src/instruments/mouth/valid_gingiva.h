// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// The gingiva at one resolution.
struct GingivaCandidate {
    TriangleMesh mesh;
    bool selfIntersects = false;
};

/// The gingiva of the first of a few resolutions, from `cell` mm on, that does not intersect itself; for nearly every
/// mouth it is the first one. `ofMouth` names the gingiva as the subject of a sentence: "The upper gum of the mouth
/// with seed 5". Fails if it intersects itself at each of them.
[[nodiscard]] Expected<TriangleMesh> firstValidGingiva(double cell,
                                                       const std::function<GingivaCandidate(double cell)>& gingivaAt,
                                                       const Message& ofMouth);

}  // namespace tactooth
