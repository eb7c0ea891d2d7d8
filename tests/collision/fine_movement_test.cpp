// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The smallest movement that changes the depth: the device presses on by 100 um down to a nanometre, on the same tooth
// at five resolutions. Each step must increase the depth, for the stateless query and for the proxy.
#include <gtest/gtest.h>

#include "collision/contact_checks.h"
#include "geometry/mesh/simplify.h"

namespace tactooth {
namespace {

constexpr double kMovements[] = {0.1, 0.05, 0.01, 0.005, 1e-3, 5e-4, 1e-4, 1e-5, 1e-6};  // mm
constexpr int kSteps = 5;

class FineMovement : public ::testing::TestWithParam<int> {};  // percent of the triangles

std::string percentName(const ::testing::TestParamInfo<int>& percent) {
    return std::to_string(percent.param) + "Percent";
}

TriangleMesh toothAt(int percent) {
    const TriangleMesh& tooth = test::oracleTeeth()[2].mesh;
    return percent == 100 ? tooth : simplified(tooth, tooth.triangles.size() * static_cast<std::size_t>(percent) / 100);
}

/// Some poses that touch, 0.02 to 0.2 mm deep.
std::vector<std::pair<Pose, Vec3>> touchingPoses(const TriangleMesh& tooth, ContactQuery& query, int count) {
    std::mt19937 random(101);
    std::vector<std::pair<Pose, Vec3>> found;
    while (static_cast<int>(found.size()) < count) {
        const Pose pose = test::randomPoseNear(tooth, 0.1, random);
        const Contact contact = query.at(pose);
        if (contact.touching && contact.depth > 0.02 && contact.depth < 0.2) found.emplace_back(pose, contact.normal);
    }
    return found;
}

}  // namespace

TEST_P(FineMovement, EachStepDownToANanometreMakesTheDepthGrow) {
    const TriangleMesh tooth = toothAt(GetParam());
    const auto surface = test::surfaceOf(tooth);
    const auto tool = test::toolOf(test::oracleTools()[0].mesh);
    ContactQuery query(tool, surface);
    ProxySolver solver(tool);
    solver.setSurface(surface);
    for (const auto& [start, outward] : touchingPoses(tooth, query, 6)) {
        for (const double movement : kMovements) {
            ASSERT_TRUE(query.at(start).touching);
            solver.placeAt(query.freePose());
            solver.moveToward(start);
            double deepest = query.at(start).depth;
            double proxyDeepest = (solver.pose().position - start.position).norm();
            for (int step = 1; step <= kSteps; ++step) {
                const Pose device{start.position - step * movement * outward, start.rotation};
                const double depth = query.at(device).depth;
                solver.moveToward(device);
                const double proxyDepth = (solver.pose().position - device.position).norm();
                EXPECT_GT(depth, deepest) << movement << " mm, step " << step;
                EXPECT_GT(proxyDepth, proxyDeepest) << movement << " mm, step " << step;
                EXPECT_LT(depth, deepest + 1.001 * movement + 1e-6) << movement << " mm, step " << step;
                deepest = depth;
                proxyDeepest = proxyDepth;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(AtFiveResolutions, FineMovement, ::testing::Values(6, 12, 25, 50, 100), percentName);

}  // namespace tactooth
