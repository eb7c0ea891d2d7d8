// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/render/renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "instruments/turbine.h"
#include "support/shapes.h"
#include "view/renderer_fixture.h"

namespace tactooth {
namespace {

using test::coveredPixelCount;
using test::kTestSize;
using test::meanColour;
using test::objectOf;
using test::sceneOf;

class RendererTest : public test::RendererTest {};

TriangleMesh ball(double radius = 3, const Vec3& centre = Vec3::Zero()) { return test::sphere(centre, radius, 96, 48); }

TEST_F(RendererTest, SilhouetteOfABallIsItsProjectedCircle) {
    const Scene scene = sceneOf({objectOf(ball())});
    const double distance = scene.camera.cameraInWorld.position.norm();
    const double edge = std::tan(std::asin(3 / distance)) / std::tan(scene.camera.fieldOfView / 2) * 120;
    const double area = std::numbers::pi * edge * edge;
    const Image image = draw(scene);
    EXPECT_NEAR(static_cast<double>(coveredPixelCount(image)), area, 0.01 * area);
    EXPECT_EQ(image.at(160, 120)[3], 255);
    EXPECT_EQ(image.at(5, 5)[3], 0);
}

TEST_F(RendererTest, MaterialsHaveTheirColours) {
    const auto colourOf = [](const Appearance& appearance) {
        return meanColour(draw(sceneOf({objectOf(ball(), appearance)})));
    };
    const Vec3 enamel = colourOf(appearances::enamel());
    const Vec3 dentin = colourOf(appearances::dentin());
    const Vec3 pulp = colourOf(appearances::pulp());
    const Vec3 caries = colourOf(appearances::caries());
    EXPECT_GT(enamel.minCoeff(), 120);
    EXPECT_LT(enamel.x() - enamel.z(), 45);
    EXPECT_GT(dentin.x() - dentin.z(), 50);
    EXPECT_GT(dentin.y() - dentin.z(), 30);
    EXPECT_GT(pulp.x(), 2 * pulp.y());
    EXPECT_LT(caries.x(), 130);
    EXPECT_GT(caries.x(), 1.5 * caries.z());
}

TEST_F(RendererTest, SidesTurnedToTheLightAreBrighter) {
    Scene scene = sceneOf({objectOf(ball())}, {0, 0});  // from +x: y to the right, z up
    scene.lighting.toKey = Vec3(0.3, -0.8, 0.5).normalized();
    const Image image = draw(scene);
    EXPECT_GT(image.at(120, 100)[1], image.at(200, 150)[1] + 40);
}

TEST_F(RendererTest, DrawsAsManyAppearancesAsAToothHasMaterials) {
    SceneObject one = objectOf(ball());
    SceneObject many = one;
    many.appearances.assign(kMaxAppearances, one.appearances.front());
    ASSERT_EQ(kMaxAppearances, kMaxMaterials + 8);  // those are for zones
    const Image wanted = draw(sceneOf({one}, {0, 0}));
    EXPECT_EQ(draw(sceneOf({many}, {0, 0})).at(160, 120), wanted.at(160, 120));
}

/// The shank of a bur is another material than its head.
TEST_F(RendererTest, ASecondAppearanceBeginsAtItsHeight) {
    const Appearance red{.colour = {0.8F, 0.1F, 0.1F}}, green{.colour = {0.1F, 0.8F, 0.1F}};
    SceneObject bur = objectOf(test::cylinder(Vec3::Zero(), 1, 2, 64), red);
    TriangleMesh above = test::cylinder(Vec3(0, 0, 2.2), 1, 2, 64);
    SceneObject shank = objectOf(std::move(above), red);
    for (SceneObject* part : {&bur, &shank}) {
        part->appearances = {red, green};
        part->secondAbove = 2.1F;
    }
    const Image image = draw(sceneOf({bur, shank}, {0, 0}));  // z up
    int lower = 0, upper = 0, wrong = 0;
    for (int y = 0; y < kTestSize.height; ++y) {
        for (int x = 0; x < kTestSize.width; ++x) {
            const Rgba pixel = image.at(x, y);
            if (pixel[3] != 255) continue;
            const bool isGreen = pixel[1] > pixel[0];
            (y < kTestSize.height / 2 ? upper : lower) += 1;
            wrong += isGreen != (y < kTestSize.height / 2) ? 1 : 0;
        }
    }
    EXPECT_GT(lower, 1000);
    EXPECT_GT(upper, 1000);
    EXPECT_EQ(wrong, 0);
    bur.secondAbove.reset();
    EXPECT_GT(meanColour(draw(sceneOf({bur}, {0, 0}))).x(), 2 * meanColour(draw(sceneOf({bur}, {0, 0}))).y());
}

TEST_F(RendererTest, AToolThrowsItsShadow) {
    SceneObject tool = objectOf(ball(0.8, Vec3(0, 0, 4)), appearances::steel());
    tool.moves = true;
    Scene scene = sceneOf({objectOf(test::box(Vec3(-4, -4, -1), Vec3(4, 4, 0))), tool}, {-1.5707963, 1.0});
    scene.lighting.toKey = Vec3(0, 0, 1);
    const auto pixel = project(scene.camera, test::kTestSize, Vec3(0, 0, 0)).value();
    const auto lit = project(scene.camera, test::kTestSize, Vec3(3, 0, 0)).value();
    const auto at = [](const Image& image, const Vec2& place) {
        return int{image.at(static_cast<int>(place.x()), static_cast<int>(place.y()))[1]};
    };
    for (const Shadows shadows : {Shadows::Hard, Shadows::Soft, Shadows::Widening}) {
        const Image image = draw(scene, {.shadows = shadows});
        EXPECT_LT(at(image, pixel), at(image, lit) - 40);
    }
    const Image without = draw(scene, {.shadows = Shadows::None});
    EXPECT_NEAR(at(without, pixel), at(without, lit), 25);
    // The shadow follows the tool although the box below it is not drawn into the shadow map again.
    scene.objects[1].objectInWorld.position = Vec3(3, 0, 0);
    const Image moved = draw(scene);
    EXPECT_LT(at(moved, lit), at(moved, pixel) - 40);
    scene.objects[1].handle = true;
    for (const bool moves : {true, false}) {
        scene.objects[1].moves = moves;
        const Image image = draw(scene);
        EXPECT_NEAR(at(image, lit), at(image, pixel), 25);
    }
}

TEST_F(RendererTest, AmbientOcclusionDarkensAnInnerEdgeAndSparesAFlatFace) {
    // A shelf and a wall that meet at x = 0, with light from above: far from the edge nothing changes.
    const Scene scene = sceneOf(
        {objectOf(test::box(Vec3(-1, -4, 0), Vec3(0, 4, 4))), objectOf(test::box(Vec3(-1, -4, -1), Vec3(6, 4, 0)))},
        {0.3, 0.9});
    const Image plain = draw(scene);
    const Image shaded = draw(scene, {.ambientOcclusion = true});
    const auto darkening = [&](const Vec3& point) {
        const Vec2 place = project(scene.camera, test::kTestSize, point).value();
        const int x = static_cast<int>(place.x());
        const int y = static_cast<int>(place.y());
        return int{plain.at(x, y)[1]} - int{shaded.at(x, y)[1]};
    };
    EXPECT_GT(darkening(Vec3(0.15, 0, 0)), 15);
    EXPECT_LT(std::abs(darkening(Vec3(4, 0, 0))), 5);
}

TEST_F(RendererTest, InvisibleObjectsAreNotDrawn) {
    Scene scene = sceneOf({objectOf(ball())});
    scene.objects[0].visible = false;
    EXPECT_EQ(coveredPixelCount(draw(scene)), 0U);
}

/// The turbine stands between the eye and the body, in each of the planes of the section. Its pixels are those of the
/// turbine alone, whatever the section takes from the body.
TEST_F(RendererTest, ASectionLeavesAnInstrumentWhole) {
    SceneObject body = objectOf(ball());
    body.sectioned = true;
    body.capAppearance = appearances::dentin();
    const Vec3 normals[] = {Vec3::UnitX(),  -Vec3::UnitX(), Vec3::UnitY(),
                            -Vec3::UnitY(), Vec3::UnitZ(),  -Vec3::UnitZ()};
    for (const OrbitCamera::Direction direction : {OrbitCamera::Direction{0.9, 0.5}, {1.5, 1.2}, {-2, 0.1}}) {
        const Vec3 toEye(std::cos(direction.elevation) * std::cos(direction.azimuth),
                         std::cos(direction.elevation) * std::sin(direction.azimuth), std::sin(direction.elevation));
        SceneObject turbine = objectOf(makeTurbine(4000), appearances::steel());
        turbine.objectInWorld.position = 60 * toEye;
        turbine.moves = turbine.handle = true;
        Scene scene = sceneOf({body, turbine}, direction);
        RenderSettings settings = kQuick;
        settings.shadows = Shadows::None;
        settings.ambientOcclusion = false;
        Scene alone = scene;
        alone.objects.erase(alone.objects.begin());
        const Image wanted = draw(alone, settings);
        ASSERT_GT(coveredPixelCount(wanted), 500U);
        for (const Vec3& normal : normals) {
            for (const double offset : {-4.0, 0.0, 15.0}) {
                scene.section = Section{{normal, offset}};
                const Image image = draw(scene, settings);
                std::size_t other = 0;
                for (std::size_t i = 0; i < image.pixels.size(); ++i) {
                    if (wanted.pixels[i][3] == 255 && image.pixels[i] != wanted.pixels[i]) ++other;
                }
                EXPECT_LT(other, coveredPixelCount(wanted) / 100) << normal.transpose() << ' ' << offset;
            }
        }
    }
}

TEST_F(RendererTest, PoseAndSpinMoveTheObject) {
    Scene scene = sceneOf({objectOf(test::box(Vec3(-3, -0.5, -0.5), Vec3(3, 0.5, 0.5)))}, {-1.5707963, 1.5707963});
    const auto covers = [&](const Image& image, const Vec3& point) {
        const Vec2 place = project(scene.camera, test::kTestSize, point).value();
        return image.at(static_cast<int>(place.x()), static_cast<int>(place.y()))[3] == 255;
    };
    EXPECT_TRUE(covers(draw(scene), Vec3(2, 0, 0.5)));
    scene.objects[0].spin = std::numbers::pi / 2;
    const Image turned = draw(scene);
    EXPECT_FALSE(covers(turned, Vec3(2, 0, 0.5)));
    EXPECT_TRUE(covers(turned, Vec3(0, 2, 0.5)));
    scene.objects[0].objectInWorld.position = Vec3(1, 0, 0);
    EXPECT_TRUE(covers(draw(scene), Vec3(1, 2, 0.5)));
}

TEST_F(RendererTest, OpenSurfacesAreDrawnFromBothSides) {
    TriangleMesh sheet;
    sheet.vertices = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    Scene scene = sceneOf({objectOf(sheet)}, {0, -1.0});
    EXPECT_EQ(coveredPixelCount(draw(scene)), 0U);
    scene.objects[0].closed = false;
    EXPECT_GT(coveredPixelCount(draw(scene)), 1000U);
}

TEST_F(RendererTest, MultisamplingSoftensTheSilhouette) {
    Scene scene = sceneOf({objectOf(ball(), appearances::caries())});
    scene.background.kind = Background::Kind::Gradient;
    scene.background.top = scene.background.bottom = Vec3f::Zero();
    const auto between = [](const Image& image) {
        return std::count_if(image.pixels.begin(), image.pixels.end(),
                             [](const Rgba& pixel) { return pixel[1] > 12 && pixel[1] < 60; });
    };
    EXPECT_GT(between(draw(scene, {.samples = 4})), between(draw(scene)) + 100);
}

TEST_F(RendererTest, SameSceneSamePicture) {
    const Scene scene = sceneOf({objectOf(ball())});
    EXPECT_EQ(draw(scene, kFine), draw(scene, kFine));
}

TEST_F(RendererTest, UnchangedShapesAreNotSentAgain) {
    Scene scene = sceneOf({objectOf(ball())});
    draw(scene);
    EXPECT_EQ(renderer().lastUpload(), 96U * 47U * 2U);
    scene.objects[0].objectInWorld.position = Vec3(1, 0, 0);
    draw(scene);
    EXPECT_EQ(renderer().lastUpload(), 0U);
}

TEST_F(RendererTest, EmptyScenesAndEmptyMeshesAreDrawn) {
    EXPECT_EQ(coveredPixelCount(draw(sceneOf({}))), 0U);
    EXPECT_EQ(coveredPixelCount(draw(sceneOf({objectOf(TriangleMesh{})}))), 0U);
}

TEST_F(RendererTest, ImpossibleSizesAreASentence) {
    for (const ImageSize size : {ImageSize{0, 10}, ImageSize{10, -1}, ImageSize{1000000, 10}}) {
        const auto image = renderer().render(sceneOf({}), size);
        ASSERT_FALSE(image);
        EXPECT_NE(image.error().message().find("choose"), std::string::npos);
    }
}

}  // namespace
}  // namespace tactooth
