// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/shadow_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/shapes.h"
#include "view/renderer_fixture.h"

namespace tactooth {
namespace {

using test::objectOf;

/// All triangles, one sample per pixel: the content of the shadow map then depends only on the scene.
constexpr RenderSettings kEveryTriangle{.shadows = Shadows::Hard};

/// A ball that is cut, a floor below it that receives its shadow, and a tool between light and ball.
class ShadowMapTest : public test::RendererTest {
protected:
    void SetUp() override {
        tool_.moves = true;
        tool_.objectInWorld.position = Vec3(-1, 0, 6);
        surface_.base = std::make_shared<const SurfacePart>(test::sphere(Vec3::Zero(), 3, 48, 24));
    }

    [[nodiscard]] Scene scene() const {
        SceneObject tooth;
        tooth.shape = std::make_shared<const Surface>(surface_);
        tooth.appearances = {appearances::enamel()};
        Scene scene = test::sceneOf({tooth, floor_, post_, tool_}, {-1.5707963, 1.0});
        scene.lighting.toKey = Vec3(0.4, 0.2, 1).normalized();
        return scene;
    }

    /// Hides the triangles from `first` up to, but not including, `end`.
    void hide(std::uint32_t first, std::uint32_t end) {
        auto mask = std::make_shared<TriangleMask>((surface_.base->mesh().triangles.size() + 63) / 64);
        for (std::uint32_t t = first; t < end; ++t) (*mask)[t / 64] |= std::uint64_t{1} << (t % 64);
        surface_.hidden = std::move(mask);
    }

    void addPatch(const Vec3& centre) {
        surface_.patches.push_back(std::make_shared<const SurfacePart>(test::sphere(centre, 0.6, 16, 8)));
    }

    /// Draws the scene after one that shares nothing with it, so that the whole map is drawn.
    static Image drawnAnew(const Scene& scene) {
        draw(test::sceneOf({objectOf(test::sphere(Vec3::Zero(), 1, 12, 6))}), kEveryTriangle);
        return draw(scene, kEveryTriangle);
    }

    /// Expects that the next picture equals that of a new renderer state. Its shadow differs from that of the uncut
    /// ball.
    void expectThatOfAnewOne() const {
        const Image followed = draw(scene(), kEveryTriangle);
        EXPECT_EQ(followed, drawnAnew(scene()));
    }

    SceneObject floor_ = objectOf(test::box(Vec3(-8, -8, -4), Vec3(8, 8, -3.5)));
    SceneObject post_ = objectOf(test::box(Vec3(7, 7, -4), Vec3(8, 8, 5)));  // keeps the frame of the map constant
    SceneObject tool_ = objectOf(test::sphere(Vec3::Zero(), 0.5, 24, 12), appearances::steel());
    Surface surface_;
};

TEST_F(ShadowMapTest, WhatIsCutAndWhatComesThrowsItsShadowAtOnce) {
    const Image whole = drawnAnew(scene());
    hide(0, 900);  // the light passes through
    expectThatOfAnewOne();
    addPatch(Vec3(4.5, -2, 0));
    expectThatOfAnewOne();
    EXPECT_NE(draw(scene(), kEveryTriangle), whole);
}

TEST_F(ShadowMapTest, WhatIsTakenBackTakesItsShadowAlong) {
    hide(0, 900);
    addPatch(Vec3(4.5, -2, 0));
    addPatch(Vec3(-4.5, -2, 0));
    drawnAnew(scene());
    surface_.patches.erase(surface_.patches.begin());
    expectThatOfAnewOne();
    hide(0, 0);
    expectThatOfAnewOne();
}

TEST_F(ShadowMapTest, ChangesOfPicturesWithoutShadowAreNotForgotten) {
    drawnAnew(scene());
    hide(0, 900);
    draw(scene(), {.shadows = Shadows::None});
    expectThatOfAnewOne();
}

TEST_F(ShadowMapTest, WhatOtherShapesReplaceThrowsNoShadowAnyMore) {
    Scene large = scene(), small = large;
    large.objects.push_back(objectOf(test::sphere(Vec3(4.5, -2, 0), 1, 24, 12)));
    small.objects.push_back(objectOf(test::sphere(Vec3(4.5, -2, 0), 0.3, 24, 12)));
    drawnAnew(large);
    const Image followed = draw(small, kEveryTriangle);
    EXPECT_EQ(followed, drawnAnew(small));
}

TEST_F(ShadowMapTest, ToolsThatMoveNearerToTheLightAreAllInTheMap) {
    drawnAnew(scene());
    for (const double height : {7.0, 20.0, 60.0, 5.0}) {
        tool_.objectInWorld.position = Vec3(0.4, 0.2, 1) * height;
        addPatch(Vec3(4.5, -height / 20, 0));
        expectThatOfAnewOne();
        const Scene shaded = scene();
        Scene open = shaded;
        open.objects.pop_back();
        const Image with = draw(shaded, kEveryTriangle), without = draw(open, kEveryTriangle);
        EXPECT_NE(with, without) << height;
    }
}

class Penumbra : public test::RendererTest {
protected:
    /// Width of the soft edge of the shadow that a bar throws from `height` mm above a plate, mm on the plate: from
    /// 90 % of the brightness to 10 %.
    static double edgeWidth(double height, const RenderSettings& settings) {
        SceneObject bar = objectOf(test::box(Vec3(-1, -20, height - 0.1), Vec3(1, 20, height)), Appearance{});
        bar.moves = true;  // leaves the map to the plate
        Scene scene = test::sceneOf({objectOf(test::box(Vec3(-20, -20, -1), Vec3(20, 20, 0)), Appearance{}), bar});
        scene.camera.cameraInWorld = {Vec3(-4, 0, 60), Quat::Identity()};
        scene.camera.fieldOfView = 2 * std::atan(5.0 / 60);  // 10 mm: 24 pixels a millimetre of the plate
        scene.lighting.toKey = Vec3(0.6, 0, 0.8);            // the bar does not hide the edge
        const Image image = draw(scene, settings);
        const double edge = -1 - 0.75 * height;
        constexpr double kAround = 0.75;  // mm: more than half of the widest edge, less than up to the bar
        const auto column = [&](double x) {
            return static_cast<int>(project(scene.camera, test::kTestSize, Vec3(x, 0, 0)).value().x());
        };
        // Over all rows, the noise of the samples cancels out.
        std::vector<double> brightness;
        for (int x = column(edge - kAround); x < column(edge + kAround); ++x) {
            int sum = 0;
            for (int y = 0; y < image.size.height; ++y) sum += image.at(x, y)[1];
            brightness.push_back(sum);
        }
        const double lit = brightness.front(), dark = brightness.back();
        EXPECT_GT(lit, 1.5 * dark);
        const auto place = [&](double share) {
            const double level = dark + share * (lit - dark);
            const auto below =
                std::find_if(brightness.begin() + 1, brightness.end(), [&](double value) { return value <= level; });
            const double above = *(below - 1);
            return static_cast<double>(below - brightness.begin()) - (level - *below) / (above - *below);
        };
        return (place(0.1) - place(0.9)) / 24;
    }
};

/// The far bar is six times as far away, and so is the width. An edge of the near one covers hardly three pixels, which
/// may make it wider by a pixel, and the samples are few: twice as wide is certain, and no fixed width reaches it.
TEST_F(Penumbra, WidensAtRestWithTheDistanceOfWhatThrowsTheShadow) {
    RenderSettings settings = kFine;
    settings.ambientOcclusion = false;  // it darkens the plate near the bar
    EXPECT_GT(edgeWidth(6, settings), 2 * edgeWidth(1, settings));
}

}  // namespace
}  // namespace tactooth
