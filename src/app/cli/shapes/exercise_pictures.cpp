// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/shapes/exercise_pictures.h"

#include <vector>

#include "app/common/mouth_scene.h"
#include "app/common/scene_builder.h"
#include "app/common/tooth_zones.h"
#include "app/gui/model/exercise_tooth.h"
#include "assessment/cavity_view.h"
#include "assessment/cavity_walls.h"
#include "session/hands/instrument_poses.h"
#include "view/camera/orbit_camera.h"

namespace tactooth {
namespace {

/// The tissue behind each triangle of the ideal shape.
std::vector<SurfaceTag> tissuesOf(const TriangleMesh& ideal, const LayeredTooth& tooth) {
    constexpr double kBehind = 0.02;  // mm: beyond what rounding moves a triangle
    std::vector<SurfaceTag> tags;
    tags.reserve(ideal.triangles.size());
    for (const Triangle& corners : ideal.triangles) {
        const Vec3 a = ideal.vertices[corners[0]].cast<double>(), b = ideal.vertices[corners[1]].cast<double>(),
                   c = ideal.vertices[corners[2]].cast<double>();
        const Vec3 normal = (b - a).cross(c - a);
        const double length = normal.norm();
        const Vec3 inward = length > 0 ? Vec3(-kBehind / length * normal) : Vec3(Vec3::Zero());
        tags.push_back(static_cast<SurfaceTag>(tooth.materialAt((a + b + c) / 3 + inward)));
    }
    return tags;
}

/// The teeth that may be touched besides.
void addNeighbours(const SurfacePart& outer, TriangleMesh& mesh, std::vector<SurfaceTag>& tags) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), outer.mesh().vertices.begin(), outer.mesh().vertices.end());
    for (std::uint32_t i = 0; i < outer.mesh().triangles.size(); ++i) {
        if (!outer.isAdjacent(i)) continue;
        Triangle corners = outer.mesh().triangles[i];
        for (std::uint32_t& corner : corners) corner += first;
        mesh.triangles.push_back(corners);
        tags.push_back(outer.tag(i));
    }
}

/// What the picture shows around: the walls to cut and some of the crown.
Box3 shownBox(const TriangleMesh& walls, const LayeredTooth& tooth) {
    constexpr double kAround = 2.2;  // mm: half a cusp
    Box3 box;
    for (const Vec3f& vertex : walls.vertices) box.extend(vertex.cast<double>());
    if (box.isEmpty()) box = tooth.ownBox();
    return {box.min().array() - kAround, box.max().array() + kAround};
}

/// From where the whole cavity is seen.
OrbitCamera eyeOn(const Exercise& exercise, const LayeredTooth& tooth) {
    const double mesialX = tooth.toothContext().mesialX;
    const auto* plan = std::get_if<PreparationPlan>(&exercise.ideal);
    const ViewDirection view = plan != nullptr ? viewOnto(*plan, tooth, mesialX) : dentistView(mesialX);
    OrbitCamera eye;
    eye.setView(OrbitCamera::Direction{view.azimuth, view.elevation});
    return eye;
}

}  // namespace

Expected<Image> exercisePicture(OffscreenRenderer& renderer, const std::shared_ptr<const Exercise>& exercise,
                                ImageSize size) {
    const Expected<SessionTooth> made = makeSessionTooth(exercise);
    if (!made) return Unexpected{made.error()};
    const std::shared_ptr<const LayeredTooth> tooth = made->piece->volume().tooth();
    Expected<TriangleMesh> ideal = idealShape(*exercise, tooth);
    if (!ideal) return Unexpected{ideal.error()};
    OrbitCamera eye = eyeOn(*exercise, *tooth);
    eye.fit(shownBox(cavityWalls(*ideal, *tooth->ownOuter()).mesh, *tooth), size.aspect());
    std::vector<SurfaceTag> tags = tissuesOf(*ideal, *tooth);
    addNeighbours(*tooth->outer(), *ideal, tags);
    auto surface = std::make_shared<Surface>();
    surface->base = std::make_shared<const SurfacePart>(std::move(*ideal), std::move(tags));
    SceneContents contents;
    contents.tooth = surface;
    contents.materials = MaterialTable(tooth->materials());
    contents.zones = toothZones(*tooth, contents.materials);
    contents.around = shownAround(made->around);
    contents.camera = eye.camera();
    return renderer.render(makeScene(contents), size);
}

}  // namespace tactooth
