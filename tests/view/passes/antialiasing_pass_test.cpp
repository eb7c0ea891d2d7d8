// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/antialiasing_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/shapes.h"
#include "view/renderer_fixture.h"

namespace tactooth {
namespace {

using test::kTestSize;
using test::objectOf;

constexpr RenderSettings kJagged{.shadows = Shadows::None};
constexpr RenderSettings kSmoothed{.shadows = Shadows::None, .antialiasing = true};

/// The mean of `side` x `side` samples for each pixel.
Image shrunk(const Image& large, int side) {
    Image small{{large.size.width / side, large.size.height / side}, {}};
    for (int y = 0; y < small.size.height; ++y) {
        for (int x = 0; x < small.size.width; ++x) {
            std::array<int, 4> sum{};
            for (int i = 0; i < side * side; ++i) {
                const Rgba& pixel = large.at(side * x + i % side, side * y + i / side);
                for (std::size_t channel = 0; channel < 4; ++channel) sum[channel] += pixel[channel];
            }
            Rgba& mean = small.pixels.emplace_back();
            for (std::size_t channel = 0; channel < 4; ++channel) {
                mean[channel] = static_cast<std::uint8_t>(std::lround(sum[channel] / double(side * side)));
            }
        }
    }
    return small;
}

/// Root of the sum of the squared differences in green, away from the border of the picture.
double differenceOf(const Image& a, const Image& b) {
    double sum = 0;
    for (int y = 20; y < a.size.height - 20; ++y) {
        for (int x = 20; x < a.size.width - 20; ++x) sum += std::pow(int{a.at(x, y)[1]} - int{b.at(x, y)[1]}, 2);
    }
    return std::sqrt(sum);
}

class AntialiasingTest : public test::RendererTest {
protected:
    /// The flat end of a bright bar on black. Its edge passes through the middle of the picture at `angle`, rad, to the
    /// rows.
    static Scene edgeAt(double angle) {
        SceneObject bar = objectOf(test::box(Vec3(-40, -40, -1), Vec3(40, 0.013, 0)), Appearance{});
        bar.objectInWorld.rotation = Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
        Scene scene = test::sceneOf({bar});
        scene.background.kind = Background::Kind::Gradient;
        scene.background.top = scene.background.bottom = Vec3f::Zero();
        scene.camera.cameraInWorld = {Vec3(0, 0, 60), Quat::Identity()};
        scene.camera.fieldOfView = 2 * std::atan(5.0 / 60);
        return scene;
    }
    /// A tooth-like body before a wall, an instrument with bright edges, stipples, and a mirror.
    static Scene busyScene() {
        Scene scene = test::sceneOf({objectOf(test::sphere(Vec3::Zero(), 3, 96, 48)),
                                     objectOf(test::box(Vec3(-6, -6, -4), Vec3(6, 6, -3)), appearances::gingiva()),
                                     objectOf(test::cylinder(Vec3(2, -2, 2), 0.4, 4, 24), appearances::steel())},
                                    {1.0, 0.7});
        scene.background = Background{};
        scene.lighting = operatingLight(scene.camera);
        SceneMirror mirror;
        mirror.mirrorInWorld.position = Vec3(0, 0, -2.5);
        mirror.radius = 5;
        scene.mirror = mirror;
        return scene;
    }
};

/// Against 64 samples a pixel.
TEST_F(AntialiasingTest, StairStepsOfAnEdgeFallToLessThanHalf) {
    constexpr int kSide = 8;
    for (const double slope : {0.04, 0.1, 0.22, 0.4, 0.7, 1.0, 1.6, 3.0, 9.0, 30.0}) {
        const Scene scene = edgeAt(std::atan(slope));
        const Image exact = shrunk(draw(scene, kJagged, {kSide * kTestSize.width, kSide * kTestSize.height}), kSide);
        const double jagged = differenceOf(draw(scene, kJagged), exact);
        const double smoothed = differenceOf(draw(scene, kSmoothed), exact);
        EXPECT_GT(jagged, 2.2 * smoothed) << slope;
    }
}

TEST_F(AntialiasingTest, WhereNeighboursHardlyDifferEachPixelStaysAsItIs) {
    const Scene scene = busyScene();
    const Image jagged = draw(scene, kQuick), smoothed = draw(scene, kMoving);
    const auto isEdge = [&](int x, int y) {
        constexpr int kSeen = 14;  // of 255
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const auto [least, most] =
                std::minmax({jagged.at(x, y)[channel], jagged.at(x - 1, y)[channel], jagged.at(x + 1, y)[channel],
                             jagged.at(x, y - 1)[channel], jagged.at(x, y + 1)[channel]});
            if (most - least > kSeen) return true;
        }
        return false;
    };
    int flat = 0, changed = 0;
    for (int y = 1; y < kTestSize.height - 1; ++y) {
        for (int x = 1; x < kTestSize.width - 1; ++x) {
            changed += jagged.at(x, y) != smoothed.at(x, y) ? 1 : 0;
            if (isEdge(x, y)) continue;
            ++flat;
            ASSERT_EQ(jagged.at(x, y), smoothed.at(x, y)) << x << ' ' << y;
        }
    }
    EXPECT_GT(flat, kTestSize.width * kTestSize.height / 2);
    EXPECT_GT(changed, 500);
}

TEST_F(AntialiasingTest, PicturesOfManySamplesStayAsTheyAre) {
    RenderSettings both = kSmooth;
    both.antialiasing = true;
    EXPECT_EQ(draw(busyScene(), both), draw(busyScene(), kSmooth));
}

/// With a section, drawing goes on in the stencil and the depth of the picture.
TEST_F(AntialiasingTest, DoesNotReachTheNextPicture) {
    Scene scene = busyScene();
    scene.objects.front().sectioned = true;
    scene.objects.front().capAppearance = appearances::dentin();
    scene.section = Section{{Vec3::UnitX(), 0.3}};
    const Image jagged = draw(scene, kQuick), smoothed = draw(scene, kMoving);
    EXPECT_NE(jagged, smoothed);
    EXPECT_EQ(draw(scene, kQuick), jagged);
    EXPECT_EQ(draw(scene, kMoving), smoothed);
}

/// The small pictures have other sizes than the large one, and a coarse one is smoothed before it is enlarged.
TEST_F(AntialiasingTest, SmoothsThePicturesOfBothEyesAndCoarseOnes) {
    for (const Stereo::Mode mode : {Stereo::Mode::Off, Stereo::Mode::SideBySide, Stereo::Mode::Anaglyph}) {
        for (const double resolution : {1.0, 0.7}) {
            Scene scene = edgeAt(0.1);
            scene.stereo = {mode, 60, 2};
            RenderSettings jagged = kJagged, smoothed = kSmoothed;
            jagged.resolution = smoothed.resolution = resolution;
            const Image exact = shrunk(draw(scene, kJagged, {4 * kTestSize.width, 4 * kTestSize.height}), 4);
            EXPECT_GT(differenceOf(draw(scene, jagged), exact), 1.3 * differenceOf(draw(scene, smoothed), exact))
                << resolution;
        }
    }
}

}  // namespace
}  // namespace tactooth
