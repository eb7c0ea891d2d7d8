// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/pulp_distance.h"

#include <gtest/gtest.h>

#include "bench_scene.h"

namespace tactooth {
namespace {

using test::at;
using test::kBurRadius;

/// A block of dentin whose top lies at zero. Its pulp is a box whose roof lies at z = -2.
std::shared_ptr<const LayeredTooth> blockWithPulp() {
    TriangleMesh outer = test::box(Vec3(-3, -3, -6), Vec3(3, 3, 0));
    std::vector<LayerMesh> layers;
    layers.push_back({"dentin", test::kDentin, outer});
    layers.push_back({"pulp", test::kPulp, test::box(Vec3(-1, -1, -5), Vec3(1, 1, -2))});
    auto tooth = LayeredTooth::make(std::move(outer), std::move(layers));
    return std::make_shared<const LayeredTooth>(std::move(*tooth));
}

TEST(PulpDistance, OfAFlatBurOverTheRoofIsItsHeight) {
    const auto tooth = blockWithPulp();
    const RevolutionEnvelope bur = test::flatBur().cutting.envelope;
    for (const double height : {1.3, 0.5, 0.02}) {
        const auto distance = distanceToPulp(*tooth, bur, at(0, 0, -2 + height), 6);
        ASSERT_TRUE(distance) << height;
        EXPECT_NEAR(*distance, height, 1e-6);
        for (const double limit : {0.9 * height, 1.1 * height}) {
            EXPECT_EQ(isNearPulp(*tooth, bur, at(0, 0, -2 + height), limit), limit > height) << height;
        }
    }
    EXPECT_LT(distanceToPulp(*tooth, bur, at(0, 0, -2.3), 6).value_or(0), 0) << "in the pulp";
}

TEST(PulpDistance, OfABurBesideTheWallIsLessItsRadius) {
    const auto tooth = blockWithPulp();
    const RevolutionEnvelope bur = test::flatBur().cutting.envelope;
    const double gap = 0.6;
    const Pose beside = at(1 + kBurRadius + gap, 0, -3);
    EXPECT_NEAR(distanceToPulp(*tooth, bur, beside, 6).value_or(0), gap, 1e-3);
    EXPECT_FALSE(isNearPulp(*tooth, bur, beside, 0.55));
    EXPECT_TRUE(isNearPulp(*tooth, bur, beside, 0.65));
}

TEST(PulpDistance, IsUnknownFarAwayAndWithoutAPulp) {
    const RevolutionEnvelope bur = test::flatBur().cutting.envelope;
    EXPECT_FALSE(distanceToPulp(*blockWithPulp(), bur, at(0, 0, 9), 6));
    EXPECT_FALSE(distanceToPulp(test::blockOnTheBench()->tooth(), bur, at(0, 0, -2), 6));
    EXPECT_FALSE(isNearPulp(test::blockOnTheBench()->tooth(), bur, at(0, 0, -2), 6));
}

/// The bur cuts down to each side of the limit; only what it cuts counts.
TEST(PulpDistance, ACutShowsThatItHasComeNearAndUndoTakesItBack) {
    CutModel model(blockWithPulp(), test::kVoxel);
    const CuttingTool bur = test::flatBur().cutting;
    const auto cutTo = [&](double left) {
        model.mark(0);
        model.sweep(bur, at(0, 0, 1), at(0, 0, -2 + left));
        model.refreshSurface();
        return model.loss().nearPulp;
    };
    EXPECT_EQ(cutTo(kAtPulp + 0.02), 0U);
    EXPECT_EQ(cutTo(kAtPulp - 0.02), 1U);
    EXPECT_TRUE(model.undo());
    EXPECT_EQ(model.loss().nearPulp, 0U);
    EXPECT_TRUE(model.redo());
    EXPECT_EQ(model.loss().nearPulp, 1U);
    EXPECT_TRUE(model.reset(1));
    EXPECT_EQ(model.loss().nearPulp, 0U);
}

}  // namespace
}  // namespace tactooth
