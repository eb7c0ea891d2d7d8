// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tip_visibility_scene.h"

#include <algorithm>

#include "app/common/inspection.h"
#include "app/gui/input/viewport.h"
#include "collision/bvh/surface.h"
#include "instruments/bur_shape.h"
#include "instruments/suction_tube.h"
#include "instruments/turbine.h"
#include "session/control/surface_ray.h"
#include "session/hands/mouse_manipulator.h"

namespace tactooth::test {
namespace {

constexpr int kToothTriangles = 8000;
constexpr double kAbove = 13;  // mm, as ToothView::fit

std::shared_ptr<const TriangleMesh> shared(TriangleMesh mesh) {
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

/// How far the bur can go on before its head touches the tooth, mm; negative if it is in the tooth: the hand may be
/// there, the bur is not. None if its tip would meet nothing.
std::optional<double> freeWay(const ToothToSee& tooth, const Aim& aim) {
    constexpr double kBack = 8;  // mm: from there the way is free
    const ShownTool& tool = *tooth.contents.tool;
    const auto way = [&](const Vec3& place) {
        return firstHit(*tooth.contents.tooth, {aim.tool * place - kBack * aim.heading, aim.heading});
    };
    const std::optional<double> ofTip = way(Vec3::Zero());
    if (!ofTip || *ofTip > 2 * kBack) return std::nullopt;
    double shortest = *ofTip;
    for (const auto& vertex : tool.bur->vertices) {
        if (static_cast<double>(vertex.z()) > tool.head.length) continue;
        if (const auto distance = way(vertex.cast<double>())) shortest = std::min(shortest, *distance);
    }
    return shortest - kBack;
}

}  // namespace

ToothToSee toothToSee(int fdi, const BurSpec& bur) {
    ToothToSee result{.mesialX = mesialX(fdi), .box = {}, .contents = {}};
    ToothRequest request;
    request.fdi = fdi;
    request.triangles = kToothTriangles;
    auto surface = std::make_shared<Surface>();
    surface->base = std::make_shared<const SurfacePart>(makeTooth(request).outer);
    result.box = surface->base->tree().box();
    SceneContents& contents = result.contents;
    contents.tooth = surface;
    ShownTool tool{.bur = shared(makeBur(bur, 2000).surface), .turbine = shared(makeTurbine()), .toolInTooth = {}};
    tool.head = burHeadOf(*tool.bur);
    tool.cap = shared(headCap(tool.head));
    contents.tool = std::move(tool);
    DentalMirror mirror = makeMirror();
    const Vec3 toEye = directionToEye(dentistView(result.mesialX));
    contents.mirror =
        ShownMirror{shared(std::move(mirror.surface)), mirror.disc, parkedMirror(result.box, toEye, result.mesialX)};
    contents.suction = ShownSuction{shared(makeSuctionTube()), parkedSuction(result.box, result.mesialX)};
    contents.glass = true;
    return result;
}

std::vector<Aim> aimsAt(const ToothToSee& tooth, StandardView view, ImageSize size) {
    OrbitCamera eye;
    eye.fit(crownBox(tooth.box, kAbove), size.aspect());
    eye.setView(view, tooth.mesialX);
    const Camera camera = eye.camera();
    const Viewport viewport(camera, size);
    const Box3 crown = crownBox(tooth.box, 0);
    std::vector<Aim> aims;
    for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
            constexpr double kApart = 0.25;  // of the crown's size
            const Vec3 aside = camera.cameraInWorld.rotation * Vec3(i, j, 0);
            const Vec3 place = crown.center() + kApart * aside.cwiseProduct(crown.sizes());
            const std::optional<Vec2> pixel = project(camera, size, place);
            if (!pixel || !firstHit(*tooth.contents.tooth, viewport.rayThrough(*pixel))) continue;
            MouseManipulator hand(tooth.box, tooth.mesialX);
            hand.aim(viewport, *pixel, *tooth.contents.tooth);
            Aim aim{camera, hand.pose(), hand.pressDirection()};
            const std::optional<double> free = freeWay(tooth, aim);
            if (!free) continue;  // the bur would go past the tooth
            aim.tool.position += std::min(0.0, *free) * aim.heading;
            aims.push_back(aim);
            if (view != StandardView::Occlusal) continue;
            aim.tool.position += std::max(0.0, *free) * aim.heading;
            aims.push_back(aim);
        }
    }
    return aims;
}

Scene sceneOf(const ToothToSee& tooth, const Aim& aim) {
    SceneContents contents = tooth.contents;
    contents.camera = aim.camera;
    contents.tool->toolInTooth = aim.tool;
    contents.tool->heading = aim.heading;
    return makeScene(contents);
}

TipVisibility TipVisibilityTest::measure(const Scene& scene) {
    const auto measured = measureTipVisibility(renderer(), scene, kPicture);
    EXPECT_TRUE(measured) << measured.error().message();
    return measured ? *measured : TipVisibility();
}

void TipVisibilityTest::expectSeen(int fdi, const char* bur) {
    const ToothToSee tooth = toothToSee(fdi, *findBur(bur));
    for (const auto& [name, view] : kStandardViews) {
        const std::vector<Aim> aims = aimsAt(tooth, view, kPicture);
        EXPECT_GE(aims.size(), 3U) << fdi << " " << name;
        for (std::size_t i = 0; i < aims.size(); ++i) {
            const TipVisibility seen = measure(sceneOf(tooth, aims[i]));
            EXPECT_GT(seen.headPixels, 30) << fdi << " " << name << ", aim " << i;
            EXPECT_GT(seen.landingPixels, 30) << fdi << " " << name << ", aim " << i;
            EXPECT_GE(seen.head, kSeen) << "head of " << bur << ", tooth " << fdi << ", " << name << ", aim " << i;
            EXPECT_GE(seen.landing, kSeen) << "landing, " << bur << ", " << fdi << ", " << name << ", aim " << i;
        }
    }
}

}  // namespace tactooth::test
