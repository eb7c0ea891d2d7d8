// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/camera/orbit_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tactooth {
namespace {

constexpr ImageSize kSize{800, 600};

const Box3 kTooth(Vec3(-5, -5, -14), Vec3(6, 5, 8));

OrbitCamera fitted() {
    OrbitCamera camera;
    camera.fit(kTooth, kSize.aspect());
    return camera;
}

/// The eye's direction as seen from the target, and the up and right directions of the picture.
struct Stand {
    Vec3 toEye;
    Vec3 up;
    Vec3 right;
};
Stand standOf(StandardView view) {
    OrbitCamera camera = fitted();
    camera.setView(view);
    const Pose pose = camera.camera().cameraInWorld;
    return {pose.rotation * Vec3::UnitZ(), pose.rotation * Vec3::UnitY(), pose.rotation * Vec3::UnitX()};
}

void expectNear(const Vec3& actual, const Vec3& wanted) {
    EXPECT_LT((actual - wanted).norm(), 1e-12) << actual.transpose();
}

TEST(OrbitCamera, OcclusalViewLooksDownOnTheCrownAsAfterLeaningOverFromBuccal) {
    const Stand stand = standOf(StandardView::Occlusal);
    expectNear(stand.toEye, Vec3::UnitZ());
    expectNear(stand.up, -Vec3::UnitY());
    expectNear(stand.right, standOf(StandardView::Buccal).right);
}

TEST(OrbitCamera, SideViewsStandOnTheirSideWithTheCrownUp) {
    const std::pair<StandardView, Vec3> sides[] = {{StandardView::Buccal, Vec3::UnitY()},
                                                   {StandardView::Lingual, -Vec3::UnitY()},
                                                   {StandardView::Mesial, Vec3::UnitX()},
                                                   {StandardView::Distal, -Vec3::UnitX()}};
    for (const auto& [view, toEye] : sides) {
        const Stand stand = standOf(view);
        expectNear(stand.toEye, toEye);
        expectNear(stand.up, Vec3::UnitZ());
        expectNear(stand.right, stand.up.cross(stand.toEye));
    }
}

/// From all sides and in wide and high pictures, by the projected points themselves.
TEST(OrbitCamera, FilledPictureShowsThePointsCentredAtTheWantedSize) {
    std::vector<Vec3> points;
    for (int i = 0; i < 2000; ++i) {
        const double angle = 0.1 * i, height = i / 2000.0;
        points.emplace_back(3 + 5 * std::cos(angle) * height, 4 * std::sin(angle), -2 + 9 * height);
    }
    for (const ImageSize size : {ImageSize{1200, 500}, ImageSize{500, 900}}) {
        for (double azimuth = 0; azimuth < 6; azimuth += 0.7) {
            for (const double elevation : {-0.4, 0.0, 0.6, std::numbers::pi / 2}) {
                OrbitCamera camera;
                camera.setView({azimuth, elevation});
                camera.fill(points, 0.8, size.aspect());
                Vec2 low(1e9, 1e9), high(-1e9, -1e9);
                for (const Vec3& point : points) {
                    const auto pixel = project(camera.camera(), size, point);
                    ASSERT_TRUE(pixel.has_value());
                    low = low.cwiseMin(*pixel);
                    high = high.cwiseMax(*pixel);
                }
                const double filled = std::max((high.x() - low.x()) / size.width, (high.y() - low.y()) / size.height);
                EXPECT_LE(filled, 0.8 + 1e-9);
                EXPECT_GE(filled, 0.7) << azimuth << ' ' << elevation;
                EXPECT_LT(((low + high) / 2 - Vec2(size.width / 2.0, size.height / 2.0)).norm(), 0.08 * size.height);
            }
        }
    }
}

TEST(OrbitCamera, FillingWithNothingChangesNothing) {
    OrbitCamera camera = fitted();
    const double before = camera.distance();
    camera.fill({}, 0.8, 1);
    EXPECT_EQ(camera.distance(), before);
}

TEST(OrbitCamera, FittedBoxIsInThePictureFromAllSides) {
    for (const ImageSize size : {ImageSize{800, 600}, ImageSize{300, 900}}) {
        OrbitCamera camera;
        camera.fit(kTooth, size.aspect());
        for (double azimuth = 0; azimuth < 6.3; azimuth += 0.3) {
            camera.setView({azimuth, 0.7});
            for (int corner = 0; corner < 8; ++corner) {
                const Vec3 point = kTooth.corner(static_cast<Box3::CornerType>(corner));
                const auto pixel = project(camera.camera(), size, point);
                ASSERT_TRUE(pixel);
                EXPECT_TRUE(pixel->x() > 0 && pixel->x() < size.width && pixel->y() > 0 && pixel->y() < size.height);
                const double depth = -(camera.camera().cameraInWorld.inverse() * point).z();
                EXPECT_GT(depth, camera.camera().nearDistance);
                EXPECT_LT(depth, camera.camera().farDistance);
            }
        }
    }
}

TEST(OrbitCamera, EmptyBoxChangesNothing) {
    OrbitCamera camera = fitted();
    const double before = camera.distance();
    camera.fit(Box3(), 1);
    EXPECT_EQ(camera.distance(), before);
}

TEST(OrbitCamera, OrbitKeepsTargetAndDistance) {
    OrbitCamera camera = fitted();
    camera.orbit(Vec2(137, -45), kSize);
    EXPECT_NEAR((camera.camera().cameraInWorld.position - camera.target()).norm(), camera.distance(), 1e-9);
    EXPECT_EQ(camera.target(), kTooth.center());
}

TEST(OrbitCamera, DraggingRightTurnsTheNearSideRight) {
    OrbitCamera camera = fitted();
    camera.setView(StandardView::Buccal);
    const Vec3 nearSide = camera.target() + Vec3(0, 3, 0);
    const double before = project(camera.camera(), kSize, nearSide)->x();
    camera.orbit(Vec2(20, 0), kSize);
    EXPECT_GT(project(camera.camera(), kSize, nearSide)->x(), before);
}

TEST(OrbitCamera, DraggingDownTurnsTheNearSideDown) {
    OrbitCamera camera = fitted();
    camera.setView(StandardView::Buccal);
    const Vec3 nearSide = camera.target() + Vec3(0, 3, 0);
    const double before = project(camera.camera(), kSize, nearSide)->y();
    camera.orbit(Vec2(0, 20), kSize);
    EXPECT_GT(project(camera.camera(), kSize, nearSide)->y(), before);
}

TEST(OrbitCamera, ElevationStopsAboveAndBelow) {
    OrbitCamera camera = fitted();
    camera.orbit(Vec2(0, 1e5), kSize);
    EXPECT_DOUBLE_EQ(camera.direction().elevation, std::numbers::pi / 2);
    camera.orbit(Vec2(0, -1e6), kSize);
    EXPECT_DOUBLE_EQ(camera.direction().elevation, -std::numbers::pi / 2);
}

TEST(OrbitCamera, PanMovesTheTargetUnderTheMouse) {
    OrbitCamera camera = fitted();
    const Vec3 point = camera.target();
    camera.pan(Vec2(31, -17), kSize);
    const auto pixel = project(camera.camera(), kSize, point);
    ASSERT_TRUE(pixel);
    EXPECT_LT((*pixel - Vec2(400 + 31, 300 - 17)).norm(), 1e-9);
}

TEST(OrbitCamera, ZoomKeepsThePointUnderTheCursor) {
    OrbitCamera camera = fitted();
    const Vec2 cursor(620, 140);
    const Ray ray = rayThrough(camera.camera(), kSize, cursor);
    const Vec3 forward = camera.camera().cameraInWorld.rotation * Vec3(0, 0, -1);
    const double beyondNear = camera.distance() - camera.camera().nearDistance;
    const Vec3 point = ray.origin + ray.direction * (beyondNear / ray.direction.dot(forward));
    camera.zoom(0.4, cursor, kSize);
    const auto pixel = project(camera.camera(), kSize, point);
    ASSERT_TRUE(pixel);
    EXPECT_LT((*pixel - cursor).norm(), 1e-9);
    EXPECT_LT(camera.pixelPitch(kSize), fitted().pixelPitch(kSize));
}

TEST(OrbitCamera, ZoomNeverReachesTheTarget) {
    OrbitCamera camera = fitted();
    for (int i = 0; i < 100; ++i) camera.zoom(0.5, Vec2(400, 300), kSize);
    EXPECT_DOUBLE_EQ(camera.distance(), 1.5);
    EXPECT_LT(camera.camera().nearDistance, camera.distance());
}

TEST(OrbitCamera, TurningAroundAPointDoesNotMoveTheEye) {
    OrbitCamera camera = fitted();
    const Pose before = camera.camera().cameraInWorld;
    camera.setPivot(Vec3(2, 1, 6));
    const Pose after = camera.camera().cameraInWorld;
    EXPECT_LT((before.position - after.position).norm(), 1e-9);
    EXPECT_NEAR(before.rotation.angularDistance(after.rotation), 0, 1e-12);
    EXPECT_NEAR((before.rotation.conjugate() * (Vec3(2, 1, 6) - before.position)).z(), -camera.distance(), 1e-9);
}

TEST(OrbitCamera, WhereMesialIsMinusXTheMesialAndTheDistalViewChangePlaces) {
    OrbitCamera camera;
    camera.setView(StandardView::Mesial, -1);
    EXPECT_NEAR((camera.camera().cameraInWorld.rotation * Vec3::UnitZ()).x(), -1, 1e-12);
    camera.setView(StandardView::Distal, -1);
    EXPECT_NEAR((camera.camera().cameraInWorld.rotation * Vec3::UnitZ()).x(), 1, 1e-12);
    camera.setView(StandardView::Buccal, -1);
    EXPECT_NEAR((camera.camera().cameraInWorld.rotation * Vec3::UnitZ()).y(), 1, 1e-12);
}

TEST(OrbitCamera, AMirroredDirectionHasItsEyeOnTheOtherSideOfX) {
    OrbitCamera one, other;
    one.setView({1.25, 0.62});
    other.setView(mirroredInX({1.25, 0.62}));
    const Vec3 eye = one.camera().cameraInWorld.position, mirrored = other.camera().cameraInWorld.position;
    EXPECT_TRUE(mirrored.isApprox(Vec3(-eye.x(), eye.y(), eye.z()), 1e-12));
}

}  // namespace
}  // namespace tactooth
