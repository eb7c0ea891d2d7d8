// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/mirror_pass.h"

#include <gtest/gtest.h>

#include "geometry/util/pose.h"
#include "support/shapes.h"
#include "view/renderer_fixture.h"

namespace tactooth {
namespace {

using test::objectOf;

/// Three coloured bodies on a table. Their picture has no symmetry.
std::vector<SceneObject> bodies() {
    return {objectOf(test::box(Vec3(-1, 0, 0), Vec3(0.5, 2, 1.5)), appearances::dentin()),
            objectOf(test::sphere(Vec3(1.6, 0.4, 0.8), 0.8, 64, 32), appearances::pulp()),
            objectOf(test::cylinder(Vec3(0.4, -1.4, 0), 0.5, 2.4, 48), appearances::enamel()),
            objectOf(test::box(Vec3(-4, -4, -0.5), Vec3(4, 4, 0)), appearances::gingiva())};
}

Camera cameraAt(const Vec3& eye, const Vec3& target) {
    const Vec3 backward = (eye - target).normalized();
    const Vec3 right = Vec3::UnitZ().cross(backward).normalized();
    Mat3 axes;
    axes << right, backward.cross(right), backward;
    return {.cameraInWorld = {eye, Quat(axes)}};
}

/// A mirror at `place` that shows `target` to `eye`.
SceneMirror mirrorBetween(const Vec3& place, const Vec3& eye, const Vec3& target, double radius) {
    SceneMirror mirror;
    const Vec3 normal = ((eye - place).normalized() + (target - place).normalized()).normalized();
    mirror.mirrorInWorld = {place, shortestRotation(Vec3::UnitZ(), normal)};
    mirror.radius = radius;
    mirror.reflectance = 1;
    return mirror;
}

/// The camera reflected in the mirror. Its picture is the reflection with left and right exchanged.
Camera reflected(const Camera& camera, const Plane& plane) {
    const Mat4 reflection = reflectionMatrix(plane);
    const Mat3 turn = reflection.topLeftCorner<3, 3>();
    Mat3 axes = turn * camera.cameraInWorld.rotation.toRotationMatrix();
    axes.col(0) = -axes.col(0);
    Camera image = camera;
    image.cameraInWorld = {(reflection * camera.cameraInWorld.position.homogeneous()).head<3>(), Quat(axes)};
    return image;
}

Image flipped(const Image& image) {
    Image result = image;
    for (int y = 0; y < image.size.height; ++y) {
        const auto row = result.pixels.begin() + std::ptrdiff_t{y} * image.size.width;
        std::reverse(row, row + image.size.width);
    }
    return result;
}

class MirrorTest : public test::RendererTest {
protected:
    /// Compares the mirror's disc with the picture from the reflected camera. Returns the number of compared pixels.
    static std::size_t expectTrueReflection(const Scene& scene, const RenderSettings& settings, double tolerance,
                                            double edgeShare = 0.004) {
        const SceneMirror mirror = scene.mirror.value();
        const Image direct = draw(scene, settings);
        Scene twin = scene;
        twin.mirror.reset();
        twin.background.kind = Background::Kind::Environment;
        twin.camera = reflected(scene.camera, mirror.planeInWorld());
        const Image wanted = flipped(draw(twin, settings));
        Image a{{0, 1}, {}};
        Image b{{0, 1}, {}};
        for (int y = 0; y < direct.size.height; ++y) {
            for (int x = 0; x < direct.size.width; ++x) {
                if (!onDisc(scene, mirror, Vec2(x + 0.5, y + 0.5))) continue;
                a.pixels.push_back(direct.at(x, y));
                b.pixels.push_back(wanted.at(x, y));
            }
        }
        a.size.width = b.size.width = static_cast<int>(a.pixels.size());
        if (a.pixels.empty()) return 0;
        const ImageDifference difference = compare(a, b);
        EXPECT_LT(difference.mean, tolerance);
        EXPECT_LT(difference.worstShare, edgeShare);
        return a.pixels.size();
    }

    static bool onDisc(const Scene& scene, const SceneMirror& mirror, const Vec2& pixel) {
        const Ray ray = rayThrough(scene.camera, test::kTestSize, pixel);
        const Plane plane = mirror.planeInWorld();
        const double approach = ray.direction.dot(plane.normal);
        if (approach >= 0) return false;
        const Vec3 hit = ray.origin - ray.direction * (plane.signedDistance(ray.origin) / approach);
        return (hit - mirror.mirrorInWorld * mirror.centre).norm() < 0.97 * mirror.radius;
    }
};

TEST_F(MirrorTest, ShowsWhatTheMirroredCameraSeesFromFivePoses) {
    const Vec3 eye(4, -13, 8);
    const Vec3 target(0.3, 0.3, 0.8);
    const Vec3 places[] = {{0.5, 4.5, 2.5}, {-4.5, 1, 3}, {4.5, 2.5, 2}, {0, 3.5, 5}, {-3, 3.6, 2.4}};
    for (const Vec3& place : places) {
        Scene scene;
        scene.objects = bodies();
        scene.camera = cameraAt(eye, place);
        scene.mirror = mirrorBetween(place, eye, target, 2);
        EXPECT_GT(expectTrueReflection(scene, kQuick, 0.6), 2000U) << place.transpose();
    }
}

TEST_F(MirrorTest, IsTrueWithManySamplesToo) {
    const Vec3 eye(4, -13, 8);
    Scene scene;
    scene.objects = bodies();
    scene.camera = cameraAt(eye, Vec3(0.5, 4.5, 2.5));
    scene.mirror = mirrorBetween(Vec3(0.5, 4.5, 2.5), eye, Vec3(0.3, 0.3, 0.8), 2);
    // The samples inside a pixel are not symmetrical, so edges differ a little more.
    EXPECT_GT(expectTrueReflection(scene, {.samples = 4}, 0.6, 0.01), 2000U);
}

/// A white ball in front of the mirror, with the mirror at several places in the picture: the reflection is lit like
/// the ball itself.
TEST_F(MirrorTest, ReflectedBodyIsAsBrightWhereverTheMirrorStandsInThePicture) {
    const Vec3 eye(0, -20, 6);
    const Vec3 place(0, 4, 1);
    for (const Vec3& lookAt : {Vec3(0, 4, 1), Vec3(-4, 4, -2), Vec3(4, 4, -2), Vec3(-4, 4, 3), Vec3(4, 4, 3)}) {
        Scene scene;
        scene.objects = {objectOf(test::sphere(Vec3(0, -2, 0), 1.2, 64, 32), appearances::enamel())};
        scene.camera = cameraAt(eye, lookAt);
        scene.mirror = mirrorBetween(place, eye, Vec3(0, -2, 0), 1.5);
        scene.lighting.toKey = (place - Vec3(0, -2, 0)).normalized();  // on the side that the mirror sees
        for (const RenderSettings& settings : {kQuick, kFine}) {
            const Image image = draw(scene, settings);
            const Vec2 middle = project(scene.camera, test::kTestSize, place).value();
            double sum = 0;
            for (int y = -3; y <= 3; ++y) {
                for (int x = -3; x <= 3; ++x) {
                    sum += image.at(static_cast<int>(middle.x()) + x, static_cast<int>(middle.y()) + y)[1];
                }
            }
            EXPECT_GT(sum / 49, 170) << lookAt.transpose() << (settings == kFine ? " fine" : " quick");
        }
    }
}

TEST_F(MirrorTest, IsTrueWithDarkenedContactsToo) {
    const Vec3 eye(4, -13, 8);
    for (const Vec3& aside : {Vec3(0, 0, 0), Vec3(2.5, 0, -1.5), Vec3(-2.5, 0, 1.5)}) {
        Scene scene;
        scene.objects = bodies();
        scene.camera = cameraAt(eye, Vec3(0.5, 4.5, 2.5) + aside);
        scene.mirror = mirrorBetween(Vec3(0.5, 4.5, 2.5), eye, Vec3(0.3, 0.3, 0.8), 2);
        // The half-size pixels of the ambient occlusion are not symmetrical.
        EXPECT_GT(expectTrueReflection(scene, {.samples = 0, .ambientOcclusion = true}, 2.0, 0.03), 1500U)
            << aside.transpose();
    }
}

TEST_F(MirrorTest, NothingBehindTheGlassIsReflected) {
    // A red ball just behind the mirror: the line of sight of the reflected eye passes through it.
    Scene scene;
    scene.objects = {objectOf(test::sphere(Vec3(0, 1.2, 0), 1.0, 48, 24), appearances::pulp())};
    const Vec3 eye(0, -20, 0);
    scene.camera = cameraAt(eye, Vec3::Zero());
    scene.mirror = mirrorBetween(Vec3::Zero(), eye, eye, 2);
    const Image image = draw(scene);
    for (int x = 140; x <= 180; ++x) {
        const Rgba pixel = image.at(x, 120);
        EXPECT_LT(int{pixel[0]}, int{pixel[2]} + 40);
    }
}

TEST_F(MirrorTest, BackOfTheMirrorShowsNothing) {
    Scene scene;
    scene.background.kind = Background::Kind::Transparent;
    const Vec3 eye(0, -20, 0);
    scene.camera = cameraAt(eye, Vec3::Zero());
    scene.mirror = mirrorBetween(Vec3::Zero(), -eye, -eye, 2);
    EXPECT_EQ(test::coveredPixelCount(draw(scene)), 0U);
    scene.mirror = mirrorBetween(Vec3::Zero(), eye, eye, 2);
    EXPECT_GT(test::coveredPixelCount(draw(scene)), 1000U);
}

TEST_F(MirrorTest, StandsInFrontOfItsOwnGlassAndBehindWhatIsNearer) {
    const Vec3 eye(0, -20, 0);
    Scene scene;
    SceneObject frame = objectOf(test::cylinder(Vec3(0, 0, -1), 2.2, 1, 64), appearances::pulp());
    scene.camera = cameraAt(eye, Vec3::Zero());
    scene.mirror = mirrorBetween(Vec3::Zero(), eye, eye, 2);
    frame.objectInWorld = scene.mirror->mirrorInWorld;
    scene.objects = {frame, objectOf(test::sphere(Vec3(0, -3, 0), 0.4, 32, 16), appearances::dentin())};
    const Image image = draw(scene);
    const auto at = [&](const Vec3& point) {
        const Vec2 place = project(scene.camera, test::kTestSize, point).value();
        return image.at(static_cast<int>(place.x()), static_cast<int>(place.y()));
    };
    const Rgba glass = at(Vec3(1.2, 0, 0));
    EXPECT_LT(int{glass[0]}, int{glass[2]} + 40);
    const Rgba nearer = at(Vec3(0, -3, 0));
    EXPECT_GT(int{nearer[0]}, int{nearer[2]} + 25);
}

TEST(MirrorPixels, CoverTheDiscAndNotMuchMore) {
    const Vec3 eye(0, -20, 0);
    const Camera camera = cameraAt(eye, Vec3::Zero());
    const SceneMirror mirror = mirrorBetween(Vec3::Zero(), eye, eye, 2);
    const PixelRectangle covered = coveredPixels(mirror, camera, {320, 240});
    const double radius = 2.0 / 20 / std::tan(camera.fieldOfView / 2) * 120;
    EXPECT_NEAR(covered.extent().x(), 2 * radius, 6);
    EXPECT_GE(covered.extent().x(), 2 * radius);
    EXPECT_NEAR(covered.low.x() + covered.high.x(), 320, 2);
    EXPECT_TRUE(coveredPixels(mirrorBetween(Vec3::Zero(), -eye, -eye, 2), camera, {320, 240}).empty());
    EXPECT_TRUE(coveredPixels(mirrorBetween(Vec3(30, 0, 0), eye, eye, 2), camera, {320, 240}).empty());
}

}  // namespace
}  // namespace tactooth
