// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/camera/second_view.h"

#include <gtest/gtest.h>

#include "support/shapes.h"
#include "view/renderer_fixture.h"

namespace tactooth {
namespace {

using test::kTestSize;
using test::objectOf;
using test::sceneOf;

class SecondViewTest : public test::RendererTest {};

/// A brick with a different appearance from every side, in front of a mirror and below a handle.
Scene sceneWithSides() {
    Scene scene = sceneOf(
        {objectOf(test::box(Vec3(-3, -2, -1), Vec3(3, 2, 1))), objectOf(test::sphere(Vec3(2, 1, 1), 1, 40, 20))});
    scene.objects.back().appearances = {appearances::caries()};
    scene.objects.push_back(objectOf(test::sphere(Vec3(0, 0, 4), 1, 40, 20), appearances::steel()));
    scene.objects.back().handle = true;
    scene.background.kind = Background::Kind::Gradient;
    SceneMirror mirror;
    mirror.mirrorInWorld.position = Vec3(0, -6, 0);
    mirror.mirrorInWorld.rotation = shortestRotation(Vec3::UnitZ(), Vec3::UnitY());
    mirror.radius = 4;
    scene.mirror = mirror;
    return scene;
}

Camera fromAbove(const Scene& scene) {
    OrbitCamera camera;
    camera.fit(boundingBox(scene), 4.0 / 3.0);
    camera.setView(StandardView::Occlusal);
    return camera.camera();
}

Image cutOut(const Image& picture, const CornerRectangle& place) {
    Image part{place.size, {}};
    for (int y = 0; y < place.size.height; ++y) {
        for (int x = 0; x < place.size.width; ++x) part.pixels.push_back(picture.at(place.left + x, place.top + y));
    }
    return part;
}

TEST(CornerRectangle, IsInTheUpperRightCornerOfEveryPicture) {
    for (const ImageSize size : {ImageSize{1280, 800}, {320, 240}, {3000, 500}, {400, 1600}, {2, 2}, {1, 1}}) {
        const CornerRectangle place = secondViewRectangle(size);
        EXPECT_GE(place.size.width, 1);
        EXPECT_GE(place.size.height, 1);
        EXPECT_GE(place.left, 0);
        EXPECT_GE(place.top, 0);
        EXPECT_LE(place.left + place.size.width, size.width);
        EXPECT_LE(place.top + place.size.height, size.height);
    }
    const CornerRectangle usual = secondViewRectangle({1280, 800});
    EXPECT_EQ(usual.size, (ImageSize{384, 288}));
    EXPECT_EQ(usual.left, 1280 - 384 - usual.top);
}

TEST_F(SecondViewTest, IsThePictureOfItsOwnCameraWithoutMirrorAndHandlesAndTheRestStaysAsItIs) {
    for (RenderSettings settings : {kQuick, kMoving, kFine}) {
        settings.shadows = Shadows::None;  // the handle throws its shadow whether it is visible or not
        Scene scene = sceneWithSides();
        const Image whole = draw(scene, settings);
        const CornerRectangle place = secondViewRectangle(kTestSize);
        Scene alone = scene;
        alone.camera = fromAbove(scene);
        alone.mirror.reset();
        alone.objects.pop_back();
        const Image expected = draw(alone, settings, place.size);
        scene.second = SecondView{alone.camera};
        const Image both = draw(scene, settings);
        EXPECT_EQ(cutOut(both, place).pixels, expected.pixels);
        EXPECT_NE(cutOut(both, place).pixels, cutOut(whole, place).pixels);
        std::size_t changed = 0;
        for (int y = 0; y < kTestSize.height; ++y) {
            for (int x = 0; x < kTestSize.width; ++x) {
                const bool inside = x >= place.left && x < place.left + place.size.width && y >= place.top &&
                                    y < place.top + place.size.height;
                changed += !inside && both.at(x, y) != whole.at(x, y) ? 1 : 0;
            }
        }
        EXPECT_EQ(changed, 0);
    }
}

TEST_F(SecondViewTest, FollowsEveryPicture) {
    Scene scene = sceneWithSides();
    scene.second = SecondView{fromAbove(scene)};
    const CornerRectangle place = secondViewRectangle(kTestSize);
    const Image before = draw(scene);
    scene.objects[1].objectInWorld.position = Vec3(-4, -2, 0);
    EXPECT_NE(cutOut(draw(scene), place).pixels, cutOut(before, place).pixels);
}

TEST_F(SecondViewTest, IsLeftOutOfStereo) {
    Scene scene = sceneWithSides();
    scene.stereo.mode = Stereo::Mode::SideBySide;
    const Image without = draw(scene);
    scene.second = SecondView{fromAbove(scene)};
    EXPECT_EQ(draw(scene).pixels, without.pixels);
}

}  // namespace
}  // namespace tactooth
