// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/demo_pictures.h"

#include <cmath>
#include <numbers>

#include "app/common/spray_particles.h"
#include "view/camera/orbit_camera.h"
#include "view/render/image.h"
#include "view/render/offscreen.h"

namespace tactooth {
namespace {

constexpr ImageSize kSize{1600, 1000};

/// The camera and the light of a picture.
struct CameraSetup {
    OrbitCamera::Direction direction;  ///< rad, for a tooth with +x mesial
    double around = 0;                 ///< margin around the subject in the picture, mm
    double above = 0;                  ///< height of the picture's centre above the subject, mm
    bool tool = true;                  ///< whether the picture shows the instrument
    bool loupeLamp = false;            ///< the light comes from near the eye and reaches the floor of a cavity
};

CameraSetup cameraSetupOf(DemoView view) {
    switch (view) {
        case DemoView::Touch:
            return {.direction = {1.80, 0.62}, .around = 5.0, .above = 1.2};  // over the cheek: the assistant's view
        case DemoView::AtWork:
            return {.direction = {1.95, 0.70}, .around = 4.2, .above = 2.6};
        case DemoView::Cut:  // the dentist's view down into the cavity, lit by the lamp on the loupe
            return {.direction = {1.65, 1.22}, .around = 1.75, .tool = false, .loupeLamp = true};
    }
    return {};
}

/// The opening of the cavity, or the bur's tip if nothing has been cut.
Vec3 subjectOf(const Surface& tooth, const Tick& tick) {
    Box3 cavity;
    for (const auto& patch : tooth.patches) cavity.extend(patch->tree().box());
    return cavity.isEmpty() ? tick.contact.proxy.position
                            : Vec3(cavity.center().x(), cavity.center().y(), cavity.max().z());
}

Camera cameraOf(const CameraSetup& shot, const Vec3& subject, double mesialX) {
    const Vec3 middle = subject + shot.above * Vec3::UnitZ();
    OrbitCamera camera;
    camera.setView(mesialX < 0 ? mirroredInX(shot.direction) : shot.direction);
    camera.fit(Box3(middle.array() - shot.around, middle.array() + shot.around), kSize.aspect());
    return camera.camera();
}

}  // namespace

Expected<void> writeDemoPicture(const std::filesystem::path& path, DemoView view, const DemoMoment& moment,
                                const DemoProps& props) {
    const auto& [tooth, tick, flying] = moment;
    Expected<OffscreenRenderer> renderer = OffscreenRenderer::create();
    if (!renderer) return Unexpected{renderer.error()};
    const CameraSetup shot = cameraSetupOf(view);
    const Vec3 subject = subjectOf(*tooth, tick);
    SceneContents contents;
    contents.tooth = tooth;
    contents.zones = props.zones;
    contents.around = props.around;
    contents.softTissues = props.softTissues;
    contents.materials = props.materials;
    contents.camera = cameraOf(shot, subject, props.mesialX);
    if (shot.tool) {
        contents.tool = props.tool;
        contents.tool->toolInTooth = tick.contact.proxy;
        contents.tool->speedRpm = tick.spindle.speedRpm;
        contents.tool->spin = std::fmod(tick.time * tick.spindle.speedRpm / 60, 1.0) * 2 * std::numbers::pi;
    }
    contents.flying = particlesOf(flying, props.materials);
    contents.mirror = props.mirror;
    if (contents.mirror) {
        const Vec3 toEye = (contents.camera.cameraInWorld.position - subject).normalized();
        contents.mirror->mirrorInTooth = parkedMirror(props.box, toEye, props.mesialX);
    }
    Scene scene = makeScene(contents);
    if (shot.loupeLamp) scene.lighting.toKey = toLoupeLamp(contents.camera);
    const Expected<Image> image = renderer->render(scene, kSize);
    if (!image) return Unexpected{image.error()};
    return writePng(*image, path);
}

}  // namespace tactooth
