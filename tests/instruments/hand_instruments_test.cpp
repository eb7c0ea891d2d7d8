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
    expectSound(makeSpoonExcavator());
    for (const HandInstrumentSpec& spec : handInstruments()) {
        expectSound(heldInstrument(spec.kind));
        expectSound(touchingInstrument(spec.kind));
    }
}

/// It comes down on its tip, and not on the belly of its hook.
TEST(HandInstruments, TheTipIsTheLowestPlaceAndTheHandleLeavesUpward) {
    for (const HandInstrumentSpec& spec : handInstruments()) {
        for (const TriangleMesh& mesh : {heldInstrument(spec.kind), touchingInstrument(spec.kind)}) {
            for (const Vec3f& v : mesh.vertices) {
                const double aside = std::hypot(v.x(), v.y());
                ASSERT_GT(v.z(), aside < 0.7 ? -0.1 : 0.05) << spec.name << ": " << v.transpose();
            }
            EXPECT_GT(boundingBox(mesh).max().x(), 10);
        }
        EXPECT_LT(touchingInstrument(spec.kind).triangles.size(), 500u);
        EXPECT_EQ(findHandInstrument(spec.name), &spec);
        EXPECT_EQ(findHandInstrument(spec.title->english), &spec);
    }
    EXPECT_EQ(findHandInstrument("fork"), nullptr);
}

TEST(HandInstruments, TheSpoonIsRoundSharpAndHollow) {
    const TriangleMesh spoon = makeSpoonExcavator();
    double width = 0, front = 1, back = 0;
    for (const Vec3f& v : spoon.vertices) {
        if (v.z() > 1.1F || v.z() < 0.1F) continue;
        width = std::max(width, std::abs(double{v.x()}));
        front = std::min(front, double{v.y()});
        back = std::max(back, double{v.y()});
    }
    EXPECT_NEAR(width, kSpoonRadius, 0.02);
    EXPECT_GT(front, -1e-3);  // nothing stands before its rim
    EXPECT_NEAR(back, 0.55 * kSpoonRadius, 0.02);
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
