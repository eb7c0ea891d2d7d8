// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/inspection.h"

#include <algorithm>

#include "app/common/tooth_zones.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

/// Colours must be comparable over the whole tooth: no gloss, no translucency.
Appearance mat(const Appearance& appearance) {
    Appearance result = appearance;
    result.roughness = 0.8F;
    result.translucency = 0;
    result.wetness = 0;
    result.grain = 0;
    return result;
}

SceneObject layerObject(const LayeredTooth::Layer& layer, const Appearance& appearance) {
    SceneObject object;
    object.shape = std::shared_ptr<const TriangleMesh>(layer.part, &layer.part->mesh());
    object.appearances = {appearance};
    object.capAppearance = appearance;
    object.capAppearance->opacity = 1;
    object.sectioned = true;
    object.inner = true;
    return object;
}

SceneObject ghostObject(CavityGhost& ghost, const std::shared_ptr<const Surface>& tooth) {
    SceneObject object;
    object.shape = ghost.over(tooth);
    object.appearances = {appearances::toCut(), appearances::outline(), appearances::outlineGap()};
    static_assert(kGhostWall == 0 && kGhostRim == 1 && kGhostRimGap == 2);
    object.sectioned = true;
    object.ghost = true;
    return object;
}

}  // namespace

bool Inspection::operator==(const Inspection& other) const {
    const bool sameSection =
        section.has_value() == other.section.has_value() &&
        (!section || (section->normal == other.section->normal && section->offset == other.section->offset));
    return sameSection && opacity == other.opacity && distances == other.distances && ghost == other.ghost;
}

Box3 crownBox(const Box3& tooth, double above) {
    constexpr double kCrown = 9;  // mm below the top of the tooth
    Box3 crown = tooth;
    crown.min().z() = std::max(tooth.min().z(), tooth.max().z() - kCrown);
    crown.max().z() += above;
    return crown;
}

std::vector<Vec3> crownCorners(const Surface* tooth, const Box3& box) {
    const Box3 crown = crownBox(box, 0);
    std::vector<Vec3> corners;
    const std::size_t count = tooth != nullptr ? tooth->base->mesh().triangles.size() : 0;
    for (std::size_t i = 0; i < count && !tooth->base->isAdjacent(static_cast<std::uint32_t>(i)); ++i) {
        for (int k = 0; k < 3; ++k) {
            const Vec3 corner = tooth->base->mesh().corner(i, k);
            if (crown.contains(corner)) corners.push_back(corner);
        }
    }
    if (!corners.empty()) return corners;
    for (int i = 0; i < 8; ++i) corners.push_back(crown.corner(static_cast<Box3::CornerType>(i)));
    return corners;
}

Camera crownCamera(StandardView side, double mesialX, const Box3& box) {
    constexpr double kAbove = 2;  // mm: room for the bur in the picture
    OrbitCamera camera;
    camera.fit(crownBox(box, kAbove), kSecondViewAspect);
    camera.setView(side, mesialX);
    return camera.camera();
}

Vec3 viewDirection(StandardView side, double mesialX) {
    switch (side) {
        case StandardView::Occlusal:
            return Vec3::UnitZ();
        case StandardView::Buccal:
            return Vec3::UnitY();
        case StandardView::Lingual:
            return -Vec3::UnitY();
        case StandardView::Mesial:
            return mesialX * Vec3::UnitX();
        case StandardView::Distal:
            return -mesialX * Vec3::UnitX();
    }
    return Vec3::UnitZ();
}

Plane sectionPlane(StandardView side, double mesialX, const Box3& box, double fromMiddle) {
    const Vec3 normal = viewDirection(side, mesialX);
    return {normal, normal.dot(box.center()) + fromMiddle};
}

void applyInspection(Scene& scene, const LayeredTooth& tooth, const Inspection& inspection) {
    TACTOOTH_ASSERT(!scene.objects.empty() && scene.objects.front().appearances.size() >= tooth.materials().size());
    SceneObject& body = scene.objects.front();
    if (inspection.section) scene.section = Section{*inspection.section};
    const std::vector<Appearance> solid = body.appearances;
    const std::vector<ZoneAppearance> zones =
        body.zones != nullptr ? zoneAppearances(tooth.materials()) : std::vector<ZoneAppearance>{};
    const std::size_t materials = solid.size() - zones.size();
    for (std::size_t i = 0; i < solid.size(); ++i) {
        const std::size_t material = i < materials ? i : static_cast<std::size_t>(zones[i - materials].material);
        body.appearances[i].opacity = inspection.opacity[material];
        if (inspection.distances) body.appearances[i] = mat(body.appearances[i]);
    }
    body.distances = inspection.distances;
    body.sectioned = true;
    body.capAppearance = solid[static_cast<std::size_t>(tooth.body())];
    if (inspection.ghost != nullptr && !inspection.ghost->empty()) {
        const auto& cut = std::get<std::shared_ptr<const Surface>>(body.shape);
        scene.objects.push_back(ghostObject(*inspection.ghost, cut));
    }
    const bool seesInside =
        std::any_of(inspection.opacity.begin(), inspection.opacity.end(), [](float opacity) { return opacity < 1; });
    if (!seesInside && !inspection.section) return;
    std::vector<SceneObject> layers;
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        const auto material = static_cast<std::size_t>(layer.material);
        Appearance appearance = solid[material];
        appearance.opacity = inspection.opacity[material];
        layers.push_back(layerObject(layer, appearance));
        // Enamel is the outermost layer: its outside is the outside of the body.
        layers.back().visible =
            seesInside && !tooth.materials().hasRole(layer.material, MaterialRole::Enamel) && appearance.opacity > 0;
    }
    scene.objects.insert(scene.objects.begin() + 1, layers.begin(), layers.end());
}

}  // namespace tactooth
