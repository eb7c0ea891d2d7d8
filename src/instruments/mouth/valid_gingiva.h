// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// A gum as one fineness gives it.
struct GingivaCandidate {
    TriangleMesh mesh;
    bool selfIntersects = false;
};

/// The gum of the coarsest of a few finenesses from `cell`, mm, on that does not cross itself: the first for nearly
/// every mouth. `ofMouth` says as the subject of a sentence whose gum it is: "The upper gum of the mouth with seed 5".
/// Fails if each of them crosses itself: such a gum is never given.
[[nodiscard]] Expected<TriangleMesh> firstValidGingiva(double cell,
                                                       const std::function<GingivaCandidate(double cell)>& gingivaAt,
                                                       const Message& ofMouth);

}  // namespace tactooth
