// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Pictures of known scenes against stored ones. README.md in this folder says how to renew them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "support/shapes.h"
#include "view/renderer_fixture.h"

namespace tactooth {
namespace {

using test::objectOf;

// Another driver rounds differently and places samples elsewhere: a mean of one grey level and one pixel in a hundred
// (edges) is below what a person sees, and any real change of look or shape is far above.
constexpr double kMeanTolerance = 1.0;
constexpr double kShareTolerance = 0.01;

/// A crown-like body: a ball with four cusps and a groove, mm.
TriangleMesh crown() {
    TriangleMesh mesh = test::sphere(Vec3::Zero(), 1, 120, 80);
    for (Vec3f& v : mesh.vertices) {
        const float cusps = 0.5F * (1 - std::cos(4 * std::atan2(v.y(), v.x()))) * std::hypot(v.x(), v.y());
        v = Vec3f(5 * v.x(), 4.5F * v.y(), (v.z() > 0 ? 3 : 6) * v.z() + (v.z() > 0 ? 1.5F * cusps : 0));
    }
    return mesh;
}

class Pictures : public test::RendererTest {
protected:
    static void expectBaseline(const std::string& name, const Scene& scene, const RenderSettings& settings = kFine) {
        const std::filesystem::path baseline = std::filesystem::path(TACTOOTH_BASELINES) / (name + ".png");
        const Image image = draw(scene, settings);
        if (std::getenv("TACTOOTH_UPDATE_BASELINES") != nullptr) {
            ASSERT_TRUE(writePng(image, baseline));
            GTEST_SKIP() << "renewed " << baseline;
        }
        const auto wanted = readPng(baseline);
        ASSERT_TRUE(wanted) << wanted.error().message;
        ASSERT_EQ(wanted->size, image.size);
        const ImageDifference difference = compare(image, *wanted);
        const bool same = difference.mean < kMeanTolerance && difference.worstShare < kShareTolerance;
        const std::string seen = name + "-seen.png";
        if (!same) {
            ASSERT_TRUE(writePng(image, seen));
        }
        EXPECT_TRUE(same) << "mean difference " << difference.mean << ", visible in a share of "
                          << difference.worstShare << " of the pixels; the picture is in "
                          << std::filesystem::absolute(seen);
    }

    static Scene lit(std::vector<SceneObject> objects, OrbitCamera::Direction direction) {
        Scene scene = test::sceneOf(std::move(objects), direction);
        scene.background = Background{};
        scene.lighting = operatingLight(scene.camera);
        return scene;
    }
};

TEST_F(Pictures, Enamel) { expectBaseline("enamel", lit({objectOf(crown(), looks::enamel())}, {1.0, 0.6})); }

TEST_F(Pictures, EnamelWithoutShadowsAndSamples) {
    expectBaseline("enamel-plain", lit({objectOf(crown(), looks::enamel())}, {1.0, 0.6}), {.shadows = Shadows::None});
}

TEST_F(Pictures, Materials) {
    const Look all[] = {looks::enamel(), looks::dentin(), looks::pulp(),    looks::caries(), looks::gingiva(),
                        looks::bone(),   looks::steel(),  looks::carbide(), looks::diamond()};
    std::vector<SceneObject> balls;
    for (int i = 0; i < 9; ++i) {
        balls.push_back(objectOf(test::sphere(Vec3(2.2 * (i % 3), -2.2 * (i / 3), 0), 1, 64, 32), all[i]));
    }
    expectBaseline("materials", lit(balls, {-1.5707963, 1.5707963}));
}

TEST_F(Pictures, BurOnCrown) {
    SceneObject bur = objectOf(test::cylinder(Vec3::Zero(), 0.6, 9, 12), looks::carbide());
    bur.objectInWorld = {Vec3(0.5, 0, 2.6), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX()))};
    bur.moves = true;
    expectBaseline("bur-on-crown", lit({objectOf(crown(), looks::enamel()), bur}, {0.8, 0.7}));
}

TEST_F(Pictures, MirrorBehindCrown) {
    Scene scene =
        lit({objectOf(crown(), looks::enamel()), objectOf(test::sphere(Vec3(0, 4.6, 0), 0.7, 48, 24), looks::caries())},
            {-1.4, 0.3});
    SceneMirror mirror;
    mirror.radius = 5;
    mirror.mirrorInWorld.position = Vec3(4, 8, 2);
    const Vec3 toEye = (scene.camera.cameraInWorld.position - mirror.mirrorInWorld.position).normalized();
    const Vec3 toCaries = (Vec3(0, 4.6, 0) - mirror.mirrorInWorld.position).normalized();
    mirror.mirrorInWorld.rotation = Quat::FromTwoVectors(Vec3::UnitZ(), toEye + toCaries);
    scene.mirror = mirror;
    expectBaseline("mirror", scene);
}

}  // namespace
}  // namespace tactooth
