// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/mirror_aim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "instruments/builtin_tooth.h"
#include "instruments/mirror.h"
#include "session/control/surface_ray.h"
#include "session/hands/chair_view.h"
#include "session/hands/instrument_poses.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

const Vec3 kLow(-5, -5, -10), kHigh(5, 5, 5);

Surface surfaceOf(TriangleMesh mesh) {
    Surface surface;
    surface.base = std::make_shared<const SurfacePart>(std::move(mesh));
    return surface;
}

MirrorAim aimAt(const Vec3& tip, const ViewDirection& from) {
    return {.tip = tip,
            .shaft = Vec3::UnitZ(),
            .eye = tip + 250 * directionToEye(from),
            .handle = -Vec3::UnitX(),
            .radius = makeMirror().disc.radius};
}

/// mm to the box, 0 inside.
double distanceToBox(const Vec3& place) { return (place - place.cwiseMax(kLow).cwiseMin(kHigh)).norm(); }

/// Whether a ray from the eye that the glass reflects passes within 0.1 mm of `place`: rays to a fine grid of the
/// glass.
bool someRayMeets(const MirrorAim& aim, const Pose& mirror, const Vec3& place, const Surface& mouth) {
    const Vec3 normal = mirror.rotation * Vec3::UnitZ();
    double nearest = std::numeric_limits<double>::infinity();
    constexpr double kStep = 0.1;
    for (double x = -aim.radius; x <= aim.radius; x += kStep) {
        for (double y = -aim.radius; y <= aim.radius; y += kStep) {
            if (std::hypot(x, y) > aim.radius) continue;
            const Vec3 onGlass = mirror * Vec3(x, y, 0);
            const Vec3 in = (onGlass - aim.eye).normalized();
            if (in.dot(normal) >= 0) continue;
            const auto before = firstHit(mouth, {aim.eye, in});
            if (before && *before < (onGlass - aim.eye).norm()) continue;
            const Vec3 out = in - 2 * in.dot(normal) * normal;
            const double along = (place - onGlass).dot(out);
            if (along < 0) continue;
            const auto after = firstHit(mouth, {onGlass, out});
            if (after && *after < along) continue;
            nearest = std::min(nearest, (place - onGlass - along * out).norm());
        }
    }
    return nearest < 0.1;
}

TEST(MirrorAim, TheGlassIsBehindTheBurAndClearOfTheTooth) {
    const Surface tooth = surfaceOf(test::box(kLow, kHigh));
    int placed = 0;
    for (const double azimuth : {0.3, 1.2, 2.5, 4.0}) {
        for (const double elevation : {0.3, 0.62, 1.0}) {
            const MirrorAim aim = aimAt(Vec3(1, -2, 5.5), {azimuth, elevation});
            const std::optional<Pose> mirror = mirrorPoseBehind(aim, tooth);
            ASSERT_TRUE(mirror) << azimuth << ' ' << elevation;
            ++placed;
            EXPECT_EQ(seenByMirror(aim, *mirror, tooth), 1);
            const Vec3 toEye = (aim.eye - aim.tip).normalized();
            EXPECT_LT((mirror->position - aim.tip).normalized().dot(toEye), 0.5);
            EXPECT_GT((mirror->rotation * Vec3::UnitZ()).dot(toEye), 0) << "the eye looks at the glass";
            for (int i = 0; i < 36; ++i) {
                const double angle = std::numbers::pi / 18 * i;
                const Vec3 rim = *mirror * (aim.radius * Vec3(std::cos(angle), std::sin(angle), 0));
                EXPECT_GT(distanceToBox(rim), 0.3) << i;
            }
        }
    }
    EXPECT_EQ(placed, 12);
}

TEST(MirrorAim, WhatIsSeenIsSeenByARayThatTheGlassReflects) {
    const Surface tooth = surfaceOf(test::box(kLow, kHigh));
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    int seen = 0, hidden = 0;
    for (int i = 0; i < 40; ++i) {
        MirrorAim aim = aimAt(Vec3(3 * uniform(random), 3 * uniform(random), 5.3), {1.3 + uniform(random), 0.6});
        aim.eye = aim.tip + 60 * (aim.eye - aim.tip).normalized();
        const Vec3 centre(6 * uniform(random), -9 + 2 * uniform(random), 6 + 4 * uniform(random));
        const Vec3 toHead = (aim.tip - centre).normalized(), toEye = (aim.eye - centre).normalized();
        const Vec3 normal =
            (toHead + toEye + 0.3 * Vec3(uniform(random), uniform(random), uniform(random))).normalized();
        const Pose mirror{centre, shortestRotation(Vec3::UnitZ(), normal)};
        // The shaft is shrunk to a point, so that all or nothing is seen.
        aim.shaft *= 1e-6;
        const double share = seenByMirror(aim, mirror, tooth);
        EXPECT_TRUE(share == 0 || share == 1) << share;
        EXPECT_EQ(share == 1, someRayMeets(aim, mirror, aim.tip, tooth)) << i;
        ++(share == 1 ? seen : hidden);
    }
    EXPECT_GT(seen, 8);
    EXPECT_GT(hidden, 8);
}

TEST(MirrorAim, ABurInsideASolidCannotBeShown) {
    const Surface tooth = surfaceOf(test::box(kLow, kHigh));
    EXPECT_FALSE(mirrorPoseBehind(aimAt(Vec3(0, 0, -5), {1.2, 0.6}), tooth));
}

TEST(MirrorAim, ShowsTheBurOnEveryKindOfTooth) {
    for (const int fdi : {11, 13, 24, 26, 36, 42, 43, 45}) {
        const Surface tooth = surfaceOf(makeTooth({.fdi = fdi, .triangles = 5000, .seed = 0, .lesion = {}}).outer);
        const Box3 box = boundingBox(tooth.base->mesh());
        const double x = mesialX(fdi);
        // Over the middle of the crown, and at its lingual side, which the eye does not see.
        const Vec3 over(box.center().x(), box.center().y(), box.max().z() + 1.5);
        const Vec3 lingual(box.center().x(), box.min().y() - 0.5, box.max().z() - 3.5);
        for (const Vec3& tip : {over, lingual}) {
            MirrorAim aim = aimAt(tip, dentistView(x));
            aim.handle = -x * Vec3::UnitX();
            const std::optional<Pose> mirror = mirrorPoseBehind(aim, tooth);
            ASSERT_TRUE(mirror) << fdi;
            EXPECT_GE(seenByMirror(aim, *mirror, tooth), 0.8) << fdi;
        }
    }
}

TEST(MirrorAim, ShowsTheChewingSurfaceOfEveryToothThatADentistSeesByTheMirror) {
    int checked = 0;
    for (int fdi = 11; fdi <= 28; ++fdi) {
        if (!isPermanentTooth(fdi) || !chairView(fdi).mirror) continue;
        const Surface tooth = surfaceOf(makeTooth({.fdi = fdi, .triangles = 5000, .seed = 0, .lesion = {}}).outer);
        const Box3 box = boundingBox(tooth.base->mesh());
        MirrorAim aim = aimAt(Vec3::Zero(), chairView(fdi).view);
        aim.handle = -mesialX(fdi) * Vec3::UnitX();
        const std::optional<Pose> mirror = mirrorPoseOverCrown(aim, box, tooth);
        ASSERT_TRUE(mirror) << fdi;
        ++checked;
        const Vec3 above(box.center().x(), box.center().y(), box.max().z() + 1);
        aim.tip = above - *firstHit(tooth, {above, -Vec3::UnitZ()}) * Vec3::UnitZ();
        EXPECT_GE(seenByMirror(aim, *mirror, tooth), 0.8) << fdi;
        EXPECT_GT((aim.eye - mirror->position).dot(mirror->rotation * Vec3::UnitZ()), 0) << fdi;
    }
    EXPECT_EQ(checked, 10);
}

}  // namespace
}  // namespace tactooth
