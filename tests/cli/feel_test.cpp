// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/motion_files.h"

namespace tactooth {
namespace {

using namespace test;

const std::array<std::string, 3> kForce = {"fx", "fy", "fz"};

class FeelCommand : public test::MotionFiles {
protected:
    ProgramRun feel(const std::string& path, const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments = {"feel",         "--tooth", plate(), "--tool", ball(),
                                              "--trajectory", path,      "--out", out()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runTactooth(arguments);
    }
    /// Down onto the plate at `speed` mm/s, 0.2 mm into it, then a rest.
    std::string pressDown(double speed) {
        std::vector<Row> rows;
        for (int tick = 0; tick < 600; ++tick) {
            const double t = 1e-3 * tick;
            rows.push_back({t, 0.4, 0.1, std::max(-0.2, 0.2 - speed * t)});
        }
        return trajectory(rows);
    }
};

TEST_F(FeelCommand, WritesTheColumnsOfItsContract) {
    const ProgramRun run = feel(pressDown(2));
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.err, IsEmpty());
    EXPECT_EQ(table().header,
              "t,x,y,z,depth,nx,ny,nz,speed,fx,fy,fz,tx,ty,tz,contacts,micros,"
              "proxy_x,proxy_y,proxy_z,proxy_qw,proxy_qx,proxy_qy,proxy_qz");
    EXPECT_EQ(table().rows.size(), 600U);
}

TEST_F(FeelCommand, WithSixDegreesOfFreedomTheProxyAlsoTurnsAwayOverAnEdge) {
    const std::string plank = file("plank.stl");
    ASSERT_TRUE(writeStl(test::box(Vec3(-1, -0.5, 0), Vec3(1, 0.5, 6)), plank));
    std::vector<Row> rows;  // half of the plank extends beyond the edge of the plate
    for (int tick = 0; tick < 300; ++tick) rows.push_back({1e-3 * tick, 9.4, 0, 0.2 - 0.002 * tick});
    const std::string path = trajectory(rows);
    expectRefused(feel(path, {"--freedom", "5"}), "--freedom");
    for (const std::string freedom : {"3", "6"}) {
        SCOPED_TRACE(freedom);
        const ProgramRun run = runTactooth(
            {"feel", "--tooth", plate(), "--tool", plank, "--trajectory", path, "--out", out(), "--freedom", freedom});
        ASSERT_EQ(run.exitCode, 0) << run.err;
        const CsvContent csv = table();
        ASSERT_EQ(csv.rows.size(), 300U);
        EXPECT_GT(csv.at(299, "fz"), 0.1);
        const double turn = csv.at(299, "proxy_qy");  // about +y: its free side tilts down
        EXPECT_TRUE(freedom == "3" ? turn == 0 : turn > 0.01) << turn;
    }
}

TEST_F(FeelCommand, TheProxyStaysOnTheSurfaceAndDepthIsItsDistanceToTheHand) {
    feel(pressDown(2));
    const CsvContent csv = table();
    int touching = 0;
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        const Vec3 hand = csv.vectorAt(row, {"x", "y", "z"});
        const Vec3 proxy = csv.vectorAt(row, {"proxy_x", "proxy_y", "proxy_z"});
        EXPECT_GT(proxy.z(), 0) << row;
        EXPECT_NEAR(csv.at(row, "depth"), (proxy - hand).norm(), 1e-12) << row;
        EXPECT_NEAR(proxy.z(), std::max(hand.z(), 0.0), 2e-5) << row;
        if (csv.at(row, "depth") > 0) {
            ++touching;
            EXPECT_NEAR(csv.at(row, "nz"), 1, 1e-6) << row;
        }
    }
    EXPECT_GT(touching, 300);
}

TEST_F(FeelCommand, TheForceIsStiffnessTimesDepthAtRest) {
    for (const double stiffness : {0.5, 1.0, 2.5}) {
        feel(pressDown(2), {"--stiffness", std::to_string(stiffness), "--damping", "0"});
        const CsvContent csv = table();
        for (std::size_t row = 0; row < csv.rows.size(); ++row) {
            const double depth = csv.at(row, "depth");
            EXPECT_NEAR(csv.vectorAt(row, kForce).norm(), stiffness * depth, 1e-9) << row;
            if (depth > 0) {
                EXPECT_GT(csv.at(row, "fz"), 0);
            }
        }
        EXPECT_NEAR(csv.at(599, "fz"), stiffness * 0.2, 1e-4);
    }
}

TEST_F(FeelCommand, TheDamperAddsItsShareOfTheDepthRateAndGoesAtRest) {
    feel(pressDown(2), {"--stiffness", "1", "--damping", "0.05"});
    const CsvContent csv = table();
    // The rate is low-passed: after 20 ms of steady sinking it equals the hand's 2 mm/s.
    const double start = 0.1;
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        const double t = csv.at(row, "t");
        const double depth = csv.at(row, "depth");
        if (t > start + 0.02 && t < 0.195) {
            EXPECT_NEAR(csv.at(row, "fz"), depth + 0.05 * 2, 1e-3) << row;
        }
        if (t > 0.25) {
            EXPECT_NEAR(csv.at(row, "fz"), depth, 1e-3) << row;
        }
    }
}

TEST_F(FeelCommand, TheForceNeverPulls) {
    std::vector<Row> rows;
    for (int tick = 0; tick < 300; ++tick) rows.push_back({1e-3 * tick, 0, 0, -0.1 + 0.005 * std::max(0, tick - 100)});
    feel(trajectory(rows), {"--stiffness", "1", "--damping", "1"});
    const CsvContent csv = table();
    for (std::size_t row = 0; row < csv.rows.size(); ++row) EXPECT_GE(csv.at(row, "fz"), 0) << row;
    EXPECT_EQ(csv.at(299, "fz"), 0);
}

TEST_F(FeelCommand, PenaltyModeHasNoMemoryAndIsNeverDeeperThanTheTruth) {
    EXPECT_EQ(feel(pressDown(2), {"--mode", "penalty"}).exitCode, 0);
    const CsvContent csv = table();
    int touching = 0;
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        touching += csv.at(row, "contacts") > 0 ? 1 : 0;
        EXPECT_LE(csv.at(row, "depth"), std::max(0.0, -csv.at(row, "z")) + 1e-6) << row;
    }
    EXPECT_GT(touching, 300);
}

TEST_F(FeelCommand, RefusesBadTrajectoriesWithOneSentenceAndNoFile) {
    for (const auto& [path, sentence] : badTrajectories()) {
        SCOPED_TRACE(sentence);
        expectRefused(feel(path), sentence);
    }
}

TEST_F(FeelCommand, RefusesBadFilesAndOptions) {
    const std::string good = trajectory({{0, 0, 0, 1}});
    expectRefused(feel(missing()), "missing: there is no such file");
    expectRefused(runTactooth({"feel", "--tooth", missing(), "--tool", ball(), "--trajectory", good, "--out", out()}),
                  "missing: there is no such file");
    EXPECT_EQ(feel(good, {"--mode", "magic"}).exitCode, 2);
    EXPECT_EQ(feel(good, {"--stiffness", "soft"}).exitCode, 2);
    EXPECT_EQ(feel(good, {"--stiffness", "-1"}).exitCode, 2);
    EXPECT_FALSE(std::filesystem::exists(out()));
}

}  // namespace
}  // namespace tactooth
