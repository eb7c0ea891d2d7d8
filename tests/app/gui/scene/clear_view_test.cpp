// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/clear_view.h"

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/util/degree.h"
#include "instruments/builtin_tooth.h"
#include "instruments/contra_angle.h"
#include "instruments/turbine.h"
#include "session/control/surface_ray.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

Surface surfaceOf(TriangleMesh mesh) {
    Surface surface;
    surface.base = std::make_shared<const SurfacePart>(std::move(mesh));
    return surface;
}

Vec3 toEye(double azimuth, double elevation) { return directionToEye({azimuth * kDegree, elevation * kDegree}); }

/// A wall 3 mm high, 2 mm in front of the tip, hides the tip up to 56 degrees: the far rim of the disc up to 45, the
/// near one up to 71.
TEST(ClearView, AWallHidesWhatIsBehindIt) {
    const Surface wall = surfaceOf(test::box(Vec3(-20, 2, 0), Vec3(20, 3, 3)));
    const Pose tip{Vec3::Zero(), Quat::Identity()};
    EXPECT_EQ(seenShare({wall}, tip, toEye(90, 30)), 0);
    EXPECT_EQ(seenShare({wall}, tip, toEye(90, 75)), 1);
    const double half = seenShare({wall}, tip, toEye(90, 56));
    EXPECT_GT(half, 0.2);
    EXPECT_LT(half, 0.8);
    EXPECT_EQ(seenShare({wall}, tip, toEye(-90, 5)), 1) << "from the other side";
}

TEST(ClearView, TheHandpieceHidesInItsOwnFrame) {
    const Surface nothing = surfaceOf(test::box(Vec3(50, 50, 50), Vec3(51, 51, 51)));
    const Surface plate = surfaceOf(test::box(Vec3(-9, 3, -9), Vec3(9, 4, 9)));  // in front of the tool's +y
    const Pose straight{Vec3(1, 2, 3), Quat::Identity()};
    const Pose turned{Vec3(1, 2, 3), Quat(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitZ()))};
    EXPECT_EQ(seenShare({nothing, &plate}, straight, toEye(90, 10)), 0);
    EXPECT_EQ(seenShare({nothing, &plate}, turned, toEye(90, 10)), 1);
    EXPECT_EQ(seenShare({nothing}, straight, toEye(90, 10)), 1) << "not shown";
}

TEST(ClearView, TheUsualViewStaysWhereItShowsTheTip) {
    const Surface floor = surfaceOf(test::box(Vec3(-5, -5, -5), Vec3(5, 5, 0)));
    const Pose tip{Vec3::Zero(), Quat::Identity()};
    const ViewDirection usual{70 * kDegree, 35 * kDegree};
    const ViewDirection found = clearView({floor}, std::array{tip}, usual);
    EXPECT_EQ(found.azimuth, usual.azimuth);
    EXPECT_EQ(found.elevation, usual.elevation);
}

/// Over the fossa of each built-in posterior tooth, with both handpieces, for both hands and both sides of the mouth.
TEST(ClearView, ShowsTheTipInEveryFossa) {
    const std::array handpieces = {surfaceOf(makeTurbine(4000)), surfaceOf(makeContraAngle(4000))};
    for (const int fdi : {46, 16, 35, 14}) {
        const Surface tooth = surfaceOf(makeTooth({.fdi = fdi, .triangles = 8000}).outer);
        const Box3 box = tooth.base->tree().box();
        const double mesialX = tactooth::mesialX(fdi);
        for (const double handleX : {mesialX, -mesialX}) {
            for (const Surface& handpiece : handpieces) {
                const Vec3 above(box.center().x(), box.center().y(), box.max().z() + 1);
                const auto fossa = firstHit(tooth, {above, -Vec3::UnitZ()});
                ASSERT_TRUE(fossa.has_value());
                const Pose tool{above - *fossa * Vec3::UnitZ(), uprightGrip(handleX, 0.4)};
                const Obstacles obstacles{tooth, &handpiece};
                const ViewDirection view = clearView(obstacles, std::array{tool}, dentistView(mesialX));
                EXPECT_GE(seenShare(obstacles, tool, directionToEye(view)), 0.9) << fdi;
            }
        }
    }
}

}  // namespace
}  // namespace tactooth
