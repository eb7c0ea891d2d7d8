// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth::test {

enum class CrownFace { Occlusal, Lingual };

/// How far a crown is from a real one after that is moved, turned and stretched along the axes to fit best. Root mean
/// squares, mm.
struct RealDistance {
    double crown;   ///< over the model's vertices
    double relief;  ///< of the heights of one face, a paraboloid taken off
};

/// `from`: height of the model from which on its crown counts.
[[nodiscard]] RealDistance distanceFromReal(const TriangleMesh& model, const TriangleMesh& real, CrownFace face,
                                            double from);

}  // namespace tactooth::test
