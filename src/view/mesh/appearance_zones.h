// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/mesh/corner_shading.h"

namespace tactooth {

/// How appearances pass into each other over a body whose tags do not say it: thin enamel into the dentin below it,
/// decay into sound tissue, gingiva into mucosa. Called from several threads at once; the same point gives the same
/// mix.
class AppearanceZones {
public:
    /// A vertex of the body.
    struct Place {
        SurfaceTag tag = 0;         ///< of the triangles there
        Vec3 point = Vec3::Zero();  ///< object frame, mm
        std::uint32_t vertex = 0;   ///< its number in the mesh; of the wall of a cut: 0
        bool isCut = false;         ///< on the wall of a cut
    };

    virtual ~AppearanceZones() = default;
    /// The appearances there, as places in SceneObject::appearances.
    [[nodiscard]] virtual AppearanceMix at(const Place& place) const = 0;
};

/// Replaces the mix of each corner that has one tag only by that of `zones`.
void applyZones(const AppearanceZones& zones, const TriangleMesh& mesh, CornerShading& shading);

/// The mix of `zones` for a place where two tags meet: each is replaced by what is strongest in its zone.
[[nodiscard]] AppearanceMix zonedMix(const AppearanceZones& zones, const AppearanceMix& mix, AppearanceZones::Place at);

}  // namespace tactooth
