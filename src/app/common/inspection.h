// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "assessment/cavity_ghost.h"
#include "tooth/model/layered_tooth.h"
#include "view/camera/orbit_camera.h"
#include "view/scene/scene.h"

namespace tactooth {

/// The five standard views with their user names: occlusal, buccal, lingual, mesial, distal.
inline constexpr std::array<std::pair<std::string_view, StandardView>, 5> kStandardViews = {
    {{"occlusal", StandardView::Occlusal},
     {"buccal", StandardView::Buccal},
     {"lingual", StandardView::Lingual},
     {"mesial", StandardView::Mesial},
     {"distal", StandardView::Distal}}};

/// The opacities of a picture in which every material is opaque.
[[nodiscard]] constexpr std::array<float, kMaxMaterials> opaque() {
    std::array<float, kMaxMaterials> all{};
    all.fill(1);
    return all;
}

/// The settings of a view into the tooth. They do not change the tooth.
struct Inspection {
    std::optional<Plane> section;                         ///< tooth frame; removes everything on its positive side
    std::array<float, kMaxMaterials> opacity = opaque();  ///< by MaterialId, 0..1
    std::optional<DistanceColourMap> distances;
    std::shared_ptr<CavityGhost> ghost;  ///< of the target of this tooth; null: none

    bool operator==(const Inspection& other) const;
};

/// The unit vector toward the eye of a standard view, tooth frame.
[[nodiscard]] Vec3 viewDirection(StandardView side, double mesialX);

/// The crown part of a tooth with this box, extended upwards by `above` mm.
[[nodiscard]] Box3 crownBox(const Box3& tooth, double above);

/// The corners of the tooth's triangles, without those of bodies around it, that lie in its crown. `box`: of the tooth.
/// The corners of the box of the crown itself if there are none. `tooth` may be null.
[[nodiscard]] std::vector<Vec3> crownCorners(const Surface* tooth, const Box3& box);

/// The camera of the second view. It shows the whole crown of a tooth with this box, wherever the main camera is.
[[nodiscard]] Camera crownCamera(StandardView side, double mesialX, const Box3& box);

/// The plane perpendicular to `side`, `fromMiddle` mm from the centre of `box` toward that side.
[[nodiscard]] Plane sectionPlane(StandardView side, double mesialX, const Box3& box, double fromMiddle);

/// Applies `inspection` to `scene`, whose first object is the tooth. Adds the ghost, and the layers, which fill a
/// section and show through transparent tissue around them.
void applyInspection(Scene& scene, const LayeredTooth& tooth, const Inspection& inspection);

}  // namespace tactooth
