// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/shapes/gallery_pictures.h"

#include <numbers>

#include "app/common/scene_builder.h"
#include "instruments/bur_shape.h"

namespace tactooth {
namespace {

/// A camera that shows a cube of this size around `centre`. It is far away, so that sizes can be compared.
Camera cameraOn(const Vec3& centre, double millimetres, OrbitCamera orbit, ImageSize size) {
    const double half = millimetres / 2;
    orbit.fit(Box3(centre.array() - half / std::numbers::sqrt3, centre.array() + half / std::numbers::sqrt3),
              size.aspect() > 1 ? size.aspect() : 1);
    return orbit.camera();
}

/// Rotates a lower tooth into the pose of an upper tooth, seen from the same side.
Quat rootsUp(StandardView view) {
    const bool fromX = view == StandardView::Mesial || view == StandardView::Distal;
    return Quat(Eigen::AngleAxisd(std::numbers::pi, fromX ? Vec3::UnitX() : Vec3::UnitY()));
}

Background plainBackground() {
    const Vec3f grey(0.235F, 0.27F, 0.31F);
    return {Background::Kind::Gradient, grey, 1.18F * grey};
}

Expected<Image> draw(OffscreenRenderer& renderer, Scene scene, ImageSize size) {
    scene.background = plainBackground();
    return renderer.render(scene, size);
}

}  // namespace

Expected<std::shared_ptr<const Surface>> shownSurface(const BuiltinTooth& tooth) {
    const Expected<LayeredTooth> layered = layeredTooth(tooth);
    if (!layered) return Unexpected{layered.error()};
    auto surface = std::make_shared<Surface>();
    surface->base = layered->outer();
    return std::shared_ptr<const Surface>(surface);
}

Expected<Image> toothPicture(OffscreenRenderer& renderer, const std::shared_ptr<const Surface>& surface, int fdi,
                             StandardView view, double millimetres, ImageSize size) {
    const bool upper = fdi < 30, occlusal = view == StandardView::Occlusal;
    OrbitCamera orbit;
    orbit.setView(view, mesialX(fdi));
    const Quat turn = upper && !occlusal ? rootsUp(view) : Quat::Identity();
    const Box3 box = surface->base->tree().box();
    SceneContents contents;
    contents.tooth = surface;
    contents.camera = cameraOn(turn * box.center(), millimetres, orbit, size);
    Scene scene = makeScene(contents);
    scene.objects.front().objectInWorld = {Vec3::Zero(), turn};
    return draw(renderer, std::move(scene), size);
}

Expected<Image> burPicture(OffscreenRenderer& renderer, const BurSpec& spec, double millimetres, ImageSize size) {
    constexpr int kTriangles = 20000;
    SceneContents contents;
    const auto bur = std::make_shared<const TriangleMesh>(makeBur(spec, kTriangles).surface);
    contents.tool = ShownTool{.bur = bur,
                              .turbine = nullptr,
                              .material = spec.material,
                              .toolInTooth = {},
                              .spin = 0,
                              .head = burHeadOf(*bur)};
    OrbitCamera orbit;
    orbit.setView({.azimuth = 0.6, .elevation = -0.25});
    contents.camera = cameraOn(Vec3(0, 0, 0.44 * millimetres), millimetres, orbit, size);
    return draw(renderer, makeScene(contents), size);
}

Expected<Image> instrumentPicture(OffscreenRenderer& renderer, const TriangleMesh& mesh, ImageSize size) {
    Scene scene;
    SceneObject object;
    object.shape = std::make_shared<const TriangleMesh>(mesh);
    object.appearances = {appearances::steel()};
    scene.objects.push_back(std::move(object));
    OrbitCamera orbit;
    orbit.setView({.azimuth = 1.2, .elevation = 0.35});
    orbit.fit(boundingBox(mesh), size.aspect());
    scene.camera = orbit.camera();
    scene.lighting = operatingLight(scene.camera);
    return draw(renderer, std::move(scene), size);
}

}  // namespace tactooth
