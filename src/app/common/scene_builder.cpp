// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/scene_builder.h"

#include <algorithm>
#include <cmath>

#include "app/common/obstacles.h"
#include "app/common/spin_blur.h"
#include "app/common/tooth_zones.h"
#include "geometry/util/pose.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

/// Adds the bur. While it rotates, adds over it the body that its blades seem to fill.
void addBur(Scene& scene, const ShownTool& tool) {
    SceneObject bur;
    bur.shape = tool.bur;
    bur.objectInWorld = tool.toolInTooth;
    const bool isDiamond = tool.material == BurMaterial::Diamond;
    bur.appearances = {isDiamond ? appearances::diamond() : appearances::carbide()};
    if (isDiamond && tool.head.length > 0) {
        bur.appearances.push_back(appearances::steel());
        bur.secondAbove = static_cast<float>(tool.head.length);
    }
    bur.moves = true;
    const float blur = tool.blurred != nullptr ? spinBlur(tool.speedRpm, tool.edge) : 0;
    bur.spin = blur < 1 ? tool.spin : 0;
    if (tool.head.length > 0) bur.glassAbove = static_cast<float>(tool.head.length);
    scene.objects.push_back(bur);
    if (tool.cap != nullptr && bur.glassAbove) {
        SceneObject cap = bur;
        cap.shape = tool.cap;
        cap.closed = false;
        *cap.glassAbove += 0.01F;  // mm: the cap itself is of the head
        cap.secondAbove.reset();
        scene.objects.push_back(std::move(cap));
    }
    if (blur == 0) return;
    constexpr float kCover = 0.86F;  // at full speed the gaps between the blades still shimmer through
    bur.shape = tool.blurred;
    bur.spin = 0;
    for (Appearance& appearance : bur.appearances) appearance.opacity = kCover * blur;
    scene.objects.push_back(std::move(bur));
}

void addTool(Scene& scene, const ShownTool& tool) {
    addBur(scene, tool);
    if (tool.turbine == nullptr) return;
    SceneObject turbine;
    turbine.shape = tool.turbine;
    turbine.objectInWorld = tool.toolInTooth;
    turbine.appearances = {appearances::handpiece()};
    turbine.moves = true;
    turbine.handle = true;
    turbine.glassAbove = kAllGlass;
    scene.objects.push_back(std::move(turbine));
}

void addMirror(Scene& scene, const ShownMirror& mirror) {
    SceneObject body;
    body.shape = mirror.mesh;
    body.objectInWorld = mirror.mirrorInTooth;
    body.appearances = {appearances::steel()};
    body.handle = true;
    body.glassAbove = kAllGlass;
    scene.objects.push_back(std::move(body));
    scene.mirror = SceneMirror{.mirrorInWorld = mirror.mirrorInTooth,
                               .centre = mirror.disc.centre,
                               .normal = mirror.disc.normal,
                               .radius = mirror.disc.radius,
                               .fog = mirror.fog,
                               .drops = mirror.drops,
                               .dirt = mirror.dirt};
}

void addSuction(Scene& scene, const ShownSuction& suction) {
    SceneObject tube;
    tube.shape = suction.mesh;
    tube.objectInWorld = suction.tubeInTooth;
    tube.appearances = {
        Appearance{.colour = {0.62F, 0.78F, 0.86F}, .roughness = 0.3F, .translucency = 0.6F, .wetness = 0.4F}};
    tube.handle = true;
    tube.glassAbove = kAllGlass;
    scene.objects.push_back(std::move(tube));
}

/// A mouth mirror reflects the operating light onto the crown that it shows. That light replaces the weak fill light if
/// it is stronger. It comes from the glass; its strength is the share of the crown's surroundings that the glass
/// covers.
void lightByMirror(Scene& scene, const Vec3& crown) {
    const SceneMirror& mirror = *scene.mirror;
    const Vec3 toGlass = mirror.mirrorInWorld * mirror.centre - crown;
    const double distance2 = std::max(toGlass.squaredNorm(), 1e-6);
    const double facing = std::max(0.0, -toGlass.dot(mirror.planeInWorld().normal) / std::sqrt(distance2));
    const double filled = mirror.radius * mirror.radius / (mirror.radius * mirror.radius + distance2);
    const Vec3f thrown = scene.lighting.keyColour * (mirror.dimmedReflectance() * static_cast<float>(facing * filled));
    if (thrown.sum() <= scene.lighting.fillColour.sum()) return;
    scene.lighting.toFill = toGlass / std::sqrt(distance2);
    scene.lighting.fillColour = thrown;
}

void addSoftTissues(Scene& scene, const SceneContents& contents, const Obstacles& obstacles) {
    for (const ShownTissue& tissue : contents.softTissues) {
        if (obstacles.hides(tissue)) continue;
        SceneObject object;
        object.shape = std::shared_ptr<const TriangleMesh>(tissue.surface, &tissue.surface->base->mesh());
        object.appearances = tissue.appearances;
        object.zones = tissue.zones;
        object.backdrop = true;
        scene.objects.push_back(std::move(object));
    }
}

/// The other tooth and its instrument, blue and transparent.
void addOther(Scene& scene, const ShownOther& other) {
    const Appearance ghost{.colour = {0.25F, 0.5F, 0.95F}, .roughness = 0.4F, .opacity = 0.35F};
    if (other.tooth != nullptr) {
        SceneObject tooth;
        tooth.shape = other.tooth;
        tooth.appearances = {ghost};
        tooth.closed = other.tooth->closed;
        scene.objects.push_back(std::move(tooth));
    }
    if (!other.tool) return;
    for (const auto& mesh : {other.tool->bur, other.tool->turbine}) {
        if (mesh == nullptr) continue;
        SceneObject part;
        part.shape = mesh;
        part.objectInWorld = other.tool->toolInTooth;
        part.appearances = {ghost};
        part.moves = true;
        part.handle = mesh != other.tool->bur;
        scene.objects.push_back(std::move(part));
    }
}

/// From the landing point to the upper end of the bur's head.
SightLine sightLine(const SceneContents& contents) {
    constexpr double kDisc = 1;      // mm around the landing point
    constexpr double kAround = 0.3;  // mm around the head
    const ShownTool& tool = *contents.tool;
    const Vec3 landing = contents.tooth != nullptr ? landingPoint(*contents.tooth, tool) : tool.toolInTooth.position;
    return {.start = landing,
            .end = tool.toolInTooth * Vec3(0, 0, tool.head.length),
            .radius = std::max(kDisc, tool.head.radius) + kAround};
}

}  // namespace

Vec3 landingPoint(const Surface& tooth, const ShownTool& tool) {
    constexpr double kFarthest = 8;  // mm: farther away, the bur is not above the tooth
    const Vec3& tip = tool.toolInTooth.position;
    const Vec3 ahead = tool.heading.value_or(tool.toolInTooth.rotation * -Vec3::UnitZ());
    const std::optional<double> distance = firstHit(tooth, {tip, ahead});
    return distance && *distance < kFarthest ? Vec3(tip + *distance * ahead) : tip;
}

std::vector<Appearance> appearancesOf(const MaterialTable& materials) {
    std::vector<Appearance> result;
    for (const MaterialId id : materials.registry().ids()) {
        const Material& material = materials[id];
        result.push_back({.colour = Vec3f(material.colour[0], material.colour[1], material.colour[2]),
                          .roughness = material.roughness,
                          .metalness = material.metalness,
                          .translucency = material.translucency,
                          .wetness = material.wetness,
                          .grain = material.grain});
    }
    return result;
}

Vec3 toLoupeLamp(const Camera& camera) { return camera.cameraInWorld.rotation * Vec3(-0.19, 0.19, 0.96).normalized(); }

Scene makeScene(const SceneContents& contents) {
    Scene scene;
    scene.camera = contents.camera;
    scene.lighting = operatingLight(contents.camera);
    if (!contents.around.empty()) scene.lighting.toKey = toLoupeLamp(contents.camera);
    if (contents.tooth != nullptr) {
        SceneObject tooth;
        tooth.shape = contents.tooth;
        tooth.appearances = appearancesOf(contents.materials);
        if (contents.zones != nullptr) {
            for (ZoneAppearance& zone : zoneAppearances(contents.materials.registry()))
                tooth.appearances.push_back(zone.appearance);
            tooth.zones = contents.zones;
        }
        tooth.closed = contents.tooth->closed;
        tooth.liquids = contents.liquids;
        scene.objects.push_back(std::move(tooth));
    }
    if (contents.tool) addTool(scene, *contents.tool);
    if (contents.tool && contents.glass) scene.sight = sightLine(contents);
    if (contents.other) addOther(scene, *contents.other);
    if (contents.mirror) addMirror(scene, *contents.mirror);
    if (contents.suction) addSuction(scene, *contents.suction);
    scene.particles = contents.flying;
    constexpr double kSteep = 0.65;  // sine of the angle from which on the opposite jaw is left out of the view
    const bool isSteep = (contents.camera.cameraInWorld.rotation * Vec3::UnitZ()).z() > kSteep;
    const Obstacles obstacles(contents);
    for (const ShownBody& body : contents.around) {
        if (body.opposite && isSteep) continue;
        const bool isHalf = obstacles.isBeyondHidden() && body.beyond;
        if (isHalf && body.beyond->ownHalf == nullptr) continue;
        SceneObject object;
        object.shape = isHalf ? body.beyond->ownHalf : body.mesh;
        object.objectInWorld = body.bodyInTooth;
        object.appearances = body.appearances;
        object.zones = isHalf ? body.beyond->zones : body.zones;
        object.liquids = contents.liquids;
        object.liquids.blood = object.liquids.slurry = 0;
        scene.objects.push_back(std::move(object));
    }
    addSoftTissues(scene, contents, obstacles);
    if (contents.mirror && contents.tooth != nullptr) lightByMirror(scene, crownOf(*contents.tooth));
    return scene;
}

}  // namespace tactooth
