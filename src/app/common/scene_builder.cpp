// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/scene_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/common/spin_blur.h"
#include "geometry/util/pose.h"

namespace tactooth {
namespace {

/// What a material looks like beside its colour and roughness.
Appearance characterOf(MaterialId id) {
    switch (id) {
        case MaterialId::Enamel:
            return appearances::enamel();
        case MaterialId::Dentin:
            return appearances::dentin();
        case MaterialId::Pulp:
            return appearances::pulp();
        case MaterialId::Caries:
            return appearances::caries();
        case MaterialId::Restoration:
            return {.translucency = 0.3F, .wetness = 0.6F, .grain = 0.05F};
        case MaterialId::Other:
            return appearances::bone();
    }
    return {};
}

/// The bur; while it turns, over it the body that its blades seem to fill.
void addBur(Scene& scene, const ShownTool& tool) {
    SceneObject bur;
    bur.shape = tool.bur;
    bur.objectInWorld = tool.toolInTooth;
    bur.appearances = {tool.material == BurMaterial::Diamond ? appearances::diamond() : appearances::carbide()};
    bur.moves = true;
    const float blur = tool.blurred != nullptr ? spinBlur(tool.speedRpm, tool.edge) : 0;
    bur.spin = blur < 1 ? tool.spin : 0;
    scene.objects.push_back(bur);
    if (blur == 0) return;
    constexpr float kCover = 0.86F;  // what lies between the blades shimmers through even at full speed
    bur.shape = tool.blurred;
    bur.spin = 0;
    bur.appearances.front().opacity = kCover * blur;
    scene.objects.push_back(std::move(bur));
}

void addTool(Scene& scene, const ShownTool& tool) {
    addBur(scene, tool);
    if (tool.turbine == nullptr) return;
    SceneObject turbine;
    turbine.shape = tool.turbine;
    turbine.objectInWorld = tool.toolInTooth;
    turbine.appearances = {appearances::steel()};
    turbine.moves = true;
    turbine.handle = true;
    scene.objects.push_back(std::move(turbine));
}

void addMirror(Scene& scene, const ShownMirror& mirror) {
    SceneObject body;
    body.shape = mirror.mesh;
    body.objectInWorld = mirror.mirrorInTooth;
    body.appearances = {appearances::steel()};
    body.handle = true;
    scene.objects.push_back(std::move(body));
    scene.mirror = SceneMirror{.mirrorInWorld = mirror.mirrorInTooth,
                               .centre = mirror.disc.centre,
                               .normal = mirror.disc.normal,
                               .radius = mirror.disc.radius,
                               .fog = mirror.fog,
                               .drops = mirror.drops};
}

void addSuction(Scene& scene, const ShownSuction& suction) {
    SceneObject tube;
    tube.shape = suction.mesh;
    tube.objectInWorld = suction.tubeInTooth;
    tube.appearances = {
        Appearance{.colour = {0.62F, 0.78F, 0.86F}, .roughness = 0.3F, .translucency = 0.6F, .wetness = 0.4F}};
    tube.handle = true;
    scene.objects.push_back(std::move(tube));
}

/// A mouth mirror throws the operating light on what it shows. That light takes the place of the weak fill light where
/// it is the stronger: from the glass to the crown, by the share of the crown's surroundings that the glass takes up.
void lightByMirror(Scene& scene, const Vec3& crown) {
    const SceneMirror& mirror = *scene.mirror;
    const Vec3 toGlass = mirror.mirrorInWorld * mirror.centre - crown;
    const double distance2 = std::max(toGlass.squaredNorm(), 1e-6);
    const double facing = std::max(0.0, -toGlass.dot(mirror.planeInWorld().normal) / std::sqrt(distance2));
    const double filled = mirror.radius * mirror.radius / (mirror.radius * mirror.radius + distance2);
    const Vec3f thrown = scene.lighting.keyColour * (mirror.reflectance * static_cast<float>(facing * filled));
    if (thrown.sum() <= scene.lighting.fillColour.sum()) return;
    scene.lighting.toFill = toGlass / std::sqrt(distance2);
    scene.lighting.fillColour = thrown;
}

/// The middle of the top of the tooth's box: near enough to the crown of any tooth.
Vec3 crownOf(const Surface& tooth) {
    constexpr double kBelowTop = 3.5;  // mm: the middle of a crown's height
    const Box3 box = tooth.base->tree().box();
    return {box.center().x(), box.center().y(), box.max().z() - kBelowTop};
}

}  // namespace

std::vector<Appearance> appearancesOf(const MaterialTable& materials) {
    std::vector<Appearance> result;
    for (std::size_t i = 0; i < kMaterialCount; ++i) {
        const auto id = static_cast<MaterialId>(i);
        Appearance appearance = characterOf(id);
        const std::array<float, 3>& colour = materials[id].colour;
        appearance.colour = Vec3f(colour[0], colour[1], colour[2]);
        appearance.roughness = materials[id].roughness;
        result.push_back(appearance);
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
        tooth.closed = contents.tooth->closed;
        scene.objects.push_back(std::move(tooth));
    }
    if (contents.tool) addTool(scene, *contents.tool);
    if (contents.mirror) addMirror(scene, *contents.mirror);
    if (contents.suction) addSuction(scene, *contents.suction);
    scene.particles = contents.flying;
    constexpr double kSteep = 0.65;  // sine of the angle from which on one looks through the other jaw
    const bool isSteep = (contents.camera.cameraInWorld.rotation * Vec3::UnitZ()).z() > kSteep;
    for (const ShownBody& body : contents.around) {
        if (body.opposite && isSteep) continue;
        SceneObject object;
        object.shape = body.mesh;
        object.objectInWorld = body.bodyInTooth;
        object.appearances = {body.appearance};
        scene.objects.push_back(std::move(object));
    }
    if (contents.mirror && contents.tooth != nullptr) lightByMirror(scene, crownOf(*contents.tooth));
    return scene;
}

Quat uprightGrip(double mesialX, double towardLingual) {
    const double angle = mesialX < 0 ? std::numbers::pi + towardLingual : -towardLingual;
    return Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
}

Pose parkedMirror(const Box3& tooth, const MirrorDisc& disc, const Vec3& toEye, double mesialX) {
    constexpr double kBehind = 8;      // mm between the tooth and the glass: room for a bur, and for a view into it
    constexpr double kAside = 6;       // mm to distal: beside the instrument, not behind it
    constexpr double kBelowTop = 3.5;  // mm from the crown's top down to the middle of its lingual side
    const Vec3 centre(tooth.center().x() - mesialX * kAside, tooth.min().y() - kBehind, tooth.max().z() - kBelowTop);
    const Vec3 lingual(tooth.center().x(), tooth.min().y(), tooth.max().z() - kBelowTop);
    const Vec3 normal = ((lingual - centre).normalized() + toEye).normalized();
    // The frame's +x, where the handle leaves, as near to distal as the tilt of the glass allows.
    const Vec3 distal = -mesialX * Vec3::UnitX();
    const Vec3 handle = (distal - distal.dot(normal) * normal).normalized();
    Mat3 axes;
    axes << handle, normal.cross(handle), normal;
    const Quat rotation(axes);
    return {centre - rotation * disc.centre, rotation};
}

Pose parkedSuction(const Box3& tooth, double mesialX) {
    constexpr double kBeside = 3.5, kBuccal = 2.0, kBelowTop = 0.5;  // mm from the crown
    const Vec3 opening(mesialX > 0 ? tooth.min().x() - kBeside : tooth.max().x() + kBeside,
                       tooth.center().y() + kBuccal, tooth.max().z() - kBelowTop);
    const Vec3 away = Vec3(-0.80 * mesialX, 0.25, 0.55).normalized();
    return {opening, shortestRotation(Vec3::UnitZ(), away)};
}

}  // namespace tactooth
