// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cavity_ghost.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/mesh/mesh_report.h"
#include "session/block_with_cavity.h"
#include "session/simulation/cut_model.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

class CavityGhostTest : public ::testing::Test {
protected:
    /// Cuts a slot of 1 mm radius, as deep as the cavity, from x = `from` to `to`.
    void cut(double from, double to) {
        const CuttingTool bur{*RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 1, 4, 48)), 1};
        model_.sweep(bur, {Vec3(from, 0, 3), Quat::Identity()}, {Vec3(to, 0, 3), Quat::Identity()});
        model_.refreshSurface();
    }
    /// The centroids of the walls that `ghost` shows for the present tooth.
    std::vector<Vec3> shownBy(CavityGhost& ghost) const {
        const std::shared_ptr<const Surface> shown = ghost.over(model_.surface());
        const TaggedMesh seen = visibleMesh(*shown);
        std::vector<Vec3> middles;
        for (std::size_t i = 0; i < seen.mesh.triangles.size(); ++i) {
            if (seen.tags[i] != kGhostWall) continue;
            middles.push_back((seen.mesh.corner(i, 0) + seen.mesh.corner(i, 1) + seen.mesh.corner(i, 2)) / 3);
        }
        return middles;
    }

    std::shared_ptr<const LayeredTooth> tooth_ =
        std::make_shared<const LayeredTooth>(*LayeredTooth::make(test::box(Vec3(-5, -5, -5), Vec3(5, 5, 5))));
    TriangleMesh target_ = test::blockWithCavity(Vec3(-2, -2, 3), Vec3(2, 2, 5));
    CavityGhost ghost_{target_, *tooth_->outer()};
    CutModel model_{tooth_, 0.05};
};

TEST_F(CavityGhostTest, ShowsAllWallsOfAWholeTooth) {
    const std::size_t walls = cavityWalls(target_, *tooth_->outer()).mesh.triangles.size();
    EXPECT_EQ(shownBy(ghost_).size(), walls);
    EXPECT_FALSE(ghost_.empty());
}

TEST_F(CavityGhostTest, IsEmptyForTheToothItself) {
    const CavityGhost ghost(tooth_->outer()->mesh(), *tooth_->outer());
    EXPECT_TRUE(ghost.empty());
}

TEST_F(CavityGhostTest, HidesTheWallsThatACutHasReached) {
    const std::vector<Vec3> walls = shownBy(ghost_);
    cut(-1, 1);
    const std::vector<Vec3> left = shownBy(ghost_);
    int hidden = 0;
    for (const Vec3& place : walls) {
        const double fromWay = std::hypot(place.x() - std::clamp(place.x(), -1.0, 1.0), place.y());
        const bool isShown = std::find(left.begin(), left.end(), place) != left.end();
        // Walls are hidden by spots of 0.1 mm: at the bur's edge it may be either.
        if (fromWay < 0.8 && place.z() < 3.001) {
            EXPECT_FALSE(isShown) << place.transpose();
            ++hidden;
        }
        if (fromWay > 1.2) {
            EXPECT_TRUE(isShown) << place.transpose();
        }
    }
    EXPECT_GT(hidden, 200);
}

TEST_F(CavityGhostTest, ShowsThemAgainWhenTheCutIsTakenBack) {
    const std::vector<Vec3> whole = shownBy(ghost_);
    model_.mark(0);
    cut(-1, 1);
    EXPECT_LT(shownBy(ghost_).size(), whole.size());
    ASSERT_TRUE(model_.undo());
    EXPECT_EQ(shownBy(ghost_), whole);
}

TEST_F(CavityGhostTest, StepByStepShowsTheSameAsAtOnce) {
    const std::pair<double, double> strokes[] = {{-1, -0.8}, {-0.8, 0.5}, {1, 0.9}, {0.9, 0.5}};
    for (const auto& [from, to] : strokes) {
        cut(from, to);
        CavityGhost fresh(target_, *tooth_->outer());
        EXPECT_EQ(shownBy(ghost_), shownBy(fresh));
    }
}

TEST_F(CavityGhostTest, KeepsTheRimOfAFinishedCavity) {
    const auto rimOf = [&](CavityGhost& ghost) {
        const std::vector<SurfaceTag> tags = visibleMesh(*ghost.over(model_.surface())).tags;
        return std::count_if(tags.begin(), tags.end(), [](SurfaceTag tag) { return tag != kGhostWall; });
    };
    const auto whole = rimOf(ghost_);
    EXPECT_GT(whole, 12 * 100);  // 16 mm of it, twelve triangles every 0.15 mm
    cut(-1, 1);
    EXPECT_EQ(rimOf(ghost_), whole);
}

TEST_F(CavityGhostTest, DrawsTheRimAsACordWithItsOutsideOutside) {
    const auto seen = visibleMesh(*ghost_.over(model_.surface()));
    TriangleMesh cord = seen.mesh;
    cord.triangles.clear();
    double length = 0;
    for (std::size_t i = 0; i < seen.mesh.triangles.size(); ++i) {
        if (seen.tags[i] != kGhostWall) cord.triangles.push_back(seen.mesh.triangles[i]);
    }
    const CavityWalls walls = cavityWalls(target_, *tooth_->outer());
    for (const auto& [from, to] : walls.rim) length += (walls.mesh.vertices[to] - walls.mesh.vertices[from]).norm();
    const double area = 3 * std::sqrt(3.0) / 2 * 0.04 * 0.04;  // of a hexagon
    EXPECT_NEAR(reportOn(cord).signedVolume, length * area, 0.1 * length * area);
}

TEST_F(CavityGhostTest, DashesTheRimAllRound) {
    const auto seen = visibleMesh(*ghost_.over(model_.surface()));
    std::vector<Vec3> dashes, gaps;
    for (std::size_t i = 0; i < seen.mesh.triangles.size(); ++i) {
        if (seen.tags[i] == kGhostRim) dashes.push_back(seen.mesh.corner(i, 0));
        if (seen.tags[i] == kGhostRimGap) gaps.push_back(seen.mesh.corner(i, 0));
    }
    const double share = static_cast<double>(gaps.size()) / static_cast<double>(gaps.size() + dashes.size());
    EXPECT_NEAR(share, 3.0 / 7, 0.06);
    const auto isNear = [](const std::vector<Vec3>& some, const Vec3& place) {
        return std::any_of(some.begin(), some.end(), [&](const Vec3& one) { return (one - place).norm() < 0.4; });
    };
    for (const Vec3& place : dashes) EXPECT_TRUE(isNear(gaps, place)) << place.transpose();
    for (const Vec3& place : gaps) EXPECT_TRUE(isNear(dashes, place)) << place.transpose();
}

TEST_F(CavityGhostTest, IsTheSameObjectUntilSomethingChanges) {
    const std::shared_ptr<const Surface> before = ghost_.over(model_.surface());
    EXPECT_EQ(ghost_.over(model_.surface()), before);
    cut(-1, 1);
    const std::shared_ptr<const Surface> after = ghost_.over(model_.surface());
    EXPECT_NE(after, before);
    EXPECT_EQ(after->base, before->base);  // what is on the graphics card stays there
    EXPECT_EQ(ghost_.over(model_.surface()), after);
}

}  // namespace
}  // namespace tactooth
