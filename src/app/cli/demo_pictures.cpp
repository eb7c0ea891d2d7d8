// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/demo_pictures.h"

#include <cmath>
#include <numbers>

#include "view/image.h"
#include "view/offscreen.h"
#include "view/orbit_camera.h"

namespace tactooth {
namespace {

constexpr PictureSize kSize{1600, 1000};
constexpr OrbitCamera::Direction kFromBuccalAndAbove{1.85, 0.78};  // rad: over the cheek, as an assistant looks
constexpr double kShownAround = 6.5;                               // mm around the middle of the crown

}  // namespace

Camera demoCamera(const Box3& tooth) {
    const Vec3 crown(tooth.center().x(), tooth.center().y(), tooth.max().z() - 1.5);
    OrbitCamera camera;
    camera.look(kFromBuccalAndAbove);
    camera.fit(Box3(crown.array() - kShownAround, crown.array() + kShownAround),
               static_cast<double>(kSize.width) / kSize.height);
    return camera.camera();
}

Expected<void> writeDemoPicture(const std::filesystem::path& path, const std::shared_ptr<const Surface>& tooth,
                                const DemoProps& props, const Tick& tick) {
    Expected<OffscreenRenderer> renderer = OffscreenRenderer::create();
    if (!renderer) return Unexpected{renderer.error()};
    SceneContents contents;
    contents.tooth = tooth;
    contents.materials = props.materials;
    contents.tool = props.tool;
    contents.tool->toolInTooth = tick.proxy;
    contents.tool->spin = std::fmod(tick.time * tick.speedRpm / 60, 1.0) * 2 * std::numbers::pi;
    contents.mirror = props.mirror;
    contents.camera = demoCamera(tooth->base->tree().box());
    const Expected<Image> image = renderer->render(makeScene(contents), kSize);
    if (!image) return Unexpected{image.error()};
    return writePng(*image, path);
}

}  // namespace tactooth
