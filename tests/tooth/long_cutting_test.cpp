// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Thousands of random moves. At each check the surface is closed, oriented and manifold, keeps the triangles of the
// file where no bur has been, and has lost the counted volume.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "geometry/io/stl_reader.h"
#include "geometry/io/stl_writer.h"
#include "geometry/mesh/mesh_report.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"
#include "support/test_data.h"
#include "tooth/surface/incremental_surface.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;

/// The report on the file of the present surface. Checks that it keeps the triangles that are not hidden.
MeshReport written(const Surface& surface) {
    const test::TemporaryFolder folder;
    EXPECT_TRUE(writeStl(visibleMesh(surface).mesh, folder / "cut.stl"));
    const TriangleMesh back = *readStl(folder / "cut.stl");
    std::size_t next = 0;
    const TriangleMesh& base = surface.base->mesh();
    for (std::uint32_t t = 0; t < base.triangles.size(); ++t) {
        if (surface.hidden && isHidden(*surface.hidden, t)) continue;
        bool same = true;
        for (int corner = 0; corner < 3; ++corner) same &= back.corner(next, corner) == base.corner(t, corner);
        EXPECT_TRUE(same) << "triangle " << t;
        if (!same) break;
        ++next;
    }
    return reportOn(back);
}

/// Strokes that begin and end anywhere around and in the body. Each has ten moves, with a bur that leans and rotates.
void cutAtRandom(TriangleMesh outer, unsigned seed, int strokes) {
    const double whole = test::volumeOf(outer);
    const Box3 box = boundingBox(outer);
    CutVolume volume(std::make_shared<const LayeredTooth>(std::move(*LayeredTooth::make(std::move(outer)))), kVoxel);
    IncrementalSurface surface(volume);
    const std::vector<RevolutionEnvelope> burs = {
        *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.25, 3, 48)),
        *RevolutionEnvelope::make(test::sphere(Vec3(0, 0, 0.4), 0.4, 48, 32))};
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto anywhere = [&] {
        const Vec3 direction(unit(random), unit(random), unit(random));
        const Quat lean(Eigen::AngleAxisd(1.5 * unit(random), Vec3(unit(random), unit(random), 0.1).normalized()));
        return Pose{box.center() + 0.55 * direction.cwiseProduct(box.sizes()), lean};
    };
    double removed = 0;
    for (int stroke = 0; stroke < strokes; ++stroke) {
        const Pose from = anywhere();
        const Pose to{from.position + 0.6 * Vec3(unit(random), unit(random), unit(random)),
                      from.rotation.slerp(0.1, anywhere().rotation)};
        const auto at = [&](int i) {
            const double t = i / 10.0;
            return Pose{from.position + t * (to.position - from.position), from.rotation.slerp(t, to.rotation)};
        };
        for (int i = 0; i < 10; ++i) {
            const CarveResult result = volume.carve(burs[random() % 2], at(i), at(i + 1));
            surface.update(volume, result.changed);
            removed += total(result.removed);
        }
        if (stroke % 20 != 19) continue;
        const MeshReport report = written(*surface.snapshot());
        ASSERT_TRUE(report.watertight()) << "seed " << seed << ", stroke " << stroke;
        ASSERT_EQ(report.duplicateTriangles, 0U);
        ASSERT_NEAR(whole - report.signedVolume, removed, 0.005 * removed + 1e-3);
    }
    EXPECT_GT(removed, 0.05 * whole) << "or little was tried";
    EXPECT_EQ(surface.failures(), 0U);
}

/// The 45th and the 69th stroke leave ridges thinner than a voxel at the surface of the ball.
TEST(LongCutting, ABallStaysClosed) { cutAtRandom(test::sphere(Vec3(0.03, -0.02, -2), 2, 96, 64), 1, 120); }

TEST(LongCutting, AThinPlateFullOfHolesStaysClosed) {
    cutAtRandom(test::box(Vec3(-2.5, -2.5, -0.3), Vec3(2.5, 2.5, 0)), 2, 80);
}

TEST(LongCutting, ARealToothStaysClosed) {
    const auto folder = test::realTeethFolder();
    if (!folder) GTEST_SKIP() << "needs a real tooth; a ball and a plate are cut above";
    cutAtRandom(*readStl(*folder / "openmandible/whole/L1_whole.stl"), 3, 160);
}

}  // namespace
}  // namespace tactooth
