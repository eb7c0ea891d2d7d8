// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// No constant of the code is an absolute length: a scene a thousand times smaller or larger gives the scaled result, a
// scene a metre away the same result.
#include <gtest/gtest.h>

#include "collision/contact_checks.h"
#include "instruments/tool_trajectory.h"

namespace tactooth {
namespace {

TriangleMesh scaled(TriangleMesh mesh, double scale) {
    for (Vec3f& vertex : mesh.vertices) vertex = (vertex.cast<double>() * scale).cast<float>();
    return mesh;
}

/// Rounded to 2^-10 mm, so that it is still exact in single precision a metre away.
TriangleMesh rounded(TriangleMesh mesh) {
    for (Vec3f& v : mesh.vertices) v = ((v * 1024).array().round().matrix() / 1024).eval();
    return mesh;
}

/// Depth of the proxy at every tick of a slide at 2 cm/s. The scene is multiplied by `scale`, then moved by `offset`.
std::vector<double> depthsAlong(const TriangleMesh& tooth, const TriangleMesh& tool, double scale, const Vec3& offset) {
    ToolTrajectory how;
    how.speed = 20;
    how.stroke = 2;
    how.strokes = 1;
    how.press = 0.2;
    TriangleMesh moved = scaled(tooth, scale);
    for (Vec3f& v : moved.vertices) v = (v.cast<double>() + offset).cast<float>();
    ProxySolver solver(test::toolOf(scaled(tool, scale)));
    solver.setSurface(test::surfaceOf(moved));
    std::vector<double> depths;
    for (const Pose& pose : toolTrajectory(tooth, how)) {
        const Pose device{scale * pose.position + offset, pose.rotation};
        if (depths.empty()) solver.placeAt(device);
        solver.moveToward(device);
        depths.push_back((solver.pose().position - device.position).norm());
    }
    return depths;
}

const TriangleMesh& molar() { return test::oracleTeeth()[2].mesh; }
const TriangleMesh& bur() { return test::oracleTools()[0].mesh; }

}  // namespace

// A power of two scales every number exactly. Any difference would come from an absolute length in the code.
TEST(Scale, TheProxyScalesWithPowersOfTwoBitForBit) {
    const std::vector<double> plain = depthsAlong(molar(), bur(), 1, Vec3::Zero());
    for (const double scale : {1.0 / 1024, 1024.0}) {
        const std::vector<double> other = depthsAlong(molar(), bur(), scale, Vec3::Zero());
        ASSERT_EQ(other.size(), plain.size());
        for (std::size_t i = 0; i < plain.size(); ++i) ASSERT_EQ(other[i], scale * plain[i]) << scale << " " << i;
    }
    EXPECT_GT(*std::max_element(plain.begin(), plain.end()), 0.1);
}

TEST(Scale, TheDepthScalesWithPowersOfTwoBitForBit) {
    for (const double scale : {1.0 / 1024, 1024.0}) {
        ContactQuery plain(test::toolOf(bur()), test::surfaceOf(molar()));
        ContactQuery other(test::toolOf(scaled(bur(), scale)), test::surfaceOf(scaled(molar(), scale)));
        std::mt19937 random(12);
        for (int i = 0; i < 40; ++i) {
            const Pose pose = test::randomPoseNear(molar(), 0.5, random);
            const Contact here = plain.at(pose);
            const Contact there = other.at({scale * pose.position, pose.rotation});
            ASSERT_EQ(here.touching, there.touching);
            ASSERT_EQ(scale * here.depth, there.depth) << i;
            ASSERT_EQ(here.normal, there.normal) << i;
        }
    }
}

// With a factor of a thousand, single precision rounds every coordinate afresh: the surface itself changes by 1e-7 of
// its size.
TEST(Scale, AFactorOfAThousandDiffersOnlyByTheRoundingOfTheFile) {
    for (const double scale : {1e-3, 1e3}) {
        ContactQuery plain(test::toolOf(bur()), test::surfaceOf(molar()));
        ContactQuery other(test::toolOf(scaled(bur(), scale)), test::surfaceOf(scaled(molar(), scale)));
        std::mt19937 random(13);
        for (int i = 0; i < 40; ++i) {
            const Pose pose = test::randomPoseNear(molar(), 0.5, random);
            const Contact here = plain.at(pose);
            const Contact there = other.at({scale * pose.position, pose.rotation});
            ASSERT_EQ(here.touching, there.touching);
            EXPECT_NEAR(here.depth, there.depth / scale, 1e-4 * here.depth + 1e-5) << i;
        }
    }
}

TEST(Scale, TheProxyAMetreAwayIsAsDeepToANanometre) {
    const TriangleMesh tooth = rounded(molar());
    const std::vector<double> here = depthsAlong(tooth, bur(), 1, Vec3::Zero());
    const std::vector<double> there = depthsAlong(tooth, bur(), 1, Vec3(1024, -1024, 1024));
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(here[i], there[i], 1e-6) << i;
}

}  // namespace tactooth
