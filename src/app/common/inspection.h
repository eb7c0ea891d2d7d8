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

/// The five standard views by the names that users give them: occlusal, buccal, lingual, mesial, distal.
inline constexpr std::array<std::pair<std::string_view, StandardView>, 5> kStandardViews = {
    {{"occlusal", StandardView::Occlusal},
     {"buccal", StandardView::Buccal},
     {"lingual", StandardView::Lingual},
     {"mesial", StandardView::Mesial},
     {"distal", StandardView::Distal}}};

/// Every material as it is.
[[nodiscard]] constexpr std::array<float, kMaxMaterials> opaque() {
    std::array<float, kMaxMaterials> all{};
    all.fill(1);
    return all;
}

/// How one looks into a tooth. Nothing of it changes the tooth.
struct Inspection {
    std::optional<Plane> section;                         ///< tooth frame; takes away what lies on its positive side
    std::array<float, kMaxMaterials> opacity = opaque();  ///< by MaterialId, 0..1
    std::optional<DistanceColourMap> distances;
    std::shared_ptr<CavityGhost> ghost;  ///< of the tooth's own target; null: none

    bool operator==(const Inspection& other) const;
};

/// The unit vector toward the eye of a standard view, tooth frame.
[[nodiscard]] Vec3 viewDirection(StandardView side, double mesialX);

/// The part of a tooth with this box that is worked on, and so many mm above it.
[[nodiscard]] Box3 crownBox(const Box3& tooth, double above);

/// What the second view shows: the crown of a tooth with this box, whole, wherever the first one has gone.
[[nodiscard]] Camera crownCamera(StandardView side, double mesialX, const Box3& box);

/// The plane square to `side`, `fromMiddle` mm from the middle of `box` toward that side.
[[nodiscard]] Plane sectionPlane(StandardView side, double mesialX, const Box3& box, double fromMiddle);

/// Lets `scene`, whose first object is the tooth, show what `inspection` asks for: adds the layers, which fill a
/// section and appear where the tissue around them is transparent, and the ghost.
void applyInspection(Scene& scene, const LayeredTooth& tooth, const Inspection& inspection);

}  // namespace tactooth
