// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "geometry/util/expected.h"
#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A gum as one fineness gives it.
struct TriedGum {
    TriangleMesh mesh;
    bool crossesItself = false;
};

/// The gum of the coarsest of a few finenesses from `cell`, mm, on that does not cross itself: the first for nearly
/// every mouth. `ofMouth` says in a sentence whose gum it is: "The upper gum of the mouth with seed 5". Fails if each
/// of them crosses itself: such a gum is never given.
[[nodiscard]] Expected<TriangleMesh> firstSoundGum(double cell, const std::function<TriedGum(double cell)>& gumAt,
                                                   const std::string& ofMouth);

}  // namespace tactooth
