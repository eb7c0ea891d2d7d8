// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/hand_instruments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/mesh/mesh_report.h"
#include "instruments/mesh_checks.h"
#include "instruments/modelling/tube.h"

namespace tactooth {
namespace {

void expectSound(const TriangleMesh& mesh) {
    EXPECT_TRUE(reportOn(mesh).watertight());
    EXPECT_GT(reportOn(mesh).signedVolume, 0);
    EXPECT_EQ(reportOn(mesh).shells.size(), 1u);
    EXPECT_FALSE(test::selfIntersects(mesh));
}

TEST(HandInstruments, AreClosedAndDoNotIntersectThemselves) {
    expectSound(makeExplorer());
    expectSound(makePeriodontalProbe());
}

TEST(HandInstruments, ExplorerEndsInAFineTipAtTheOrigin) {
    double widest = 0;
    for (const Vec3f& v : makeExplorer().vertices) {
        if (v.norm() < 0.12F) widest = std::max(widest, static_cast<double>(v.norm()));
    }
    EXPECT_GT(widest, 0.05);
    EXPECT_LT(widest, 0.12);
    EXPECT_GT(boundingBox(makeExplorer()).max().z(), 100);
}

TEST(HandInstruments, ProbeIsBluntAndHasARingAtEachMark) {
    const TriangleMesh probe = makePeriodontalProbe();
    const auto radiusAt = [&](double z) {
        double radius = 0;
        for (const Vec3f& v : probe.vertices) {
            if (std::abs(v.z() - z) < 0.2 && v.z() < 11)
                radius = std::max(radius, std::hypot(double{v.x()}, double{v.y()}));
        }
        return radius;
    };
    EXPECT_NEAR(2 * radiusAt(0.2), 0.5, 0.01);
    for (const double mark : kProbeMarks) {
        const bool ring = std::ranges::any_of(probe.vertices, [&](const Vec3f& v) {
            return std::abs(v.z() - mark) < 0.13 && std::hypot(v.x(), v.y()) < radiusAt(mark) - 0.03;
        });
        EXPECT_TRUE(ring) << mark;
    }
}

TEST(Tube, StraightTubeIsACylinder) {
    const std::vector<TubePoint> points = {{{0, 0, 0}, 1}, {{0, 0, 3}, 1}};
    const TriangleMesh mesh = tube(smoothed(points, 4), 64);
    const double polygon = 64 / 2.0 * std::sin(2 * 3.14159265358979 / 64);
    EXPECT_NEAR(reportOn(mesh).signedVolume, 3 * polygon, 1e-4);
}

}  // namespace
}  // namespace tactooth
