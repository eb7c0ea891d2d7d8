// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/workspace_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "devices/base/device_presets.h"

namespace tactooth {
namespace {

Quat aboutUp(double angle) { return Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())); }

TEST(WorkspaceFit, IsTheTightestOfTheThreeAxes) {
    EXPECT_DOUBLE_EQ(fitWorkspace(Vec3(160, 70, 120), Vec3(20, 35, 20)).motionScaling, 2);
    EXPECT_DOUBLE_EQ(fitWorkspace(Vec3(30, 70, 120), Vec3(20, 35, 20)).motionScaling, 1.5);
    EXPECT_DOUBLE_EQ(fitWorkspace(Vec3(160, 70, 24), Vec3(20, 35, 20)).motionScaling, 1.2);
}

TEST(WorkspaceFit, StaysInItsRangeAndSaysIfNotAllIsReached) {
    EXPECT_EQ(fitWorkspace(Vec3(300, 200, 300), Vec3(20, 20, 20)).motionScaling, kMaxMotionScaling);
    EXPECT_TRUE(fitWorkspace(Vec3(20, 20, 20), Vec3(20, 20, 20)).coversBox);
    EXPECT_EQ(fitWorkspace(Vec3(20, 20, 20), Vec3(20, 20, 20)).motionScaling, kMinMotionScaling);
    EXPECT_FALSE(fitWorkspace(Vec3(20, 19.9, 20), Vec3(20, 20, 20)).coversBox);
    EXPECT_EQ(fitWorkspace(Vec3(20, 19.9, 20), Vec3(20, 20, 20)).motionScaling, kMinMotionScaling);
    EXPECT_FALSE(fitWorkspace(Vec3::Constant(std::nan("")), Vec3(20, 20, 20)).coversBox);
}

TEST(WorkspaceFit, RoundsDownToTenths) {
    EXPECT_DOUBLE_EQ(fitWorkspace(Vec3(59.9, 70, 70), Vec3(20, 20, 20)).motionScaling, 2.9);
    EXPECT_EQ(fitWorkspace(Vec3(46, 70, 70), Vec3(20, 20, 20)).motionScaling, 2.3) << "46 / 20 is not 2.29";
}

TEST(WorkspaceFit, ABoxIsMeasuredAlongTheAxesOfTheHand) {
    const Vec3 size(10, 20, 30);
    EXPECT_LT((sizeInDeviceFrame(size, Quat::Identity()) - size).norm(), 1e-12);
    EXPECT_LT((sizeInDeviceFrame(size, aboutUp(std::numbers::pi / 2)) - Vec3(20, 10, 30)).norm(), 1e-12);
    const double diagonal = 30 / std::numbers::sqrt2;  // (10 + 20) cos 45 degrees
    EXPECT_LT((sizeInDeviceFrame(size, aboutUp(std::numbers::pi / 4)) - Vec3(diagonal, diagonal, 30)).norm(), 1e-12);
}

/// The motion scaling must let the tool reach every corner of the box from within the workspace.
TEST(WorkspaceFit, EveryPresetReachesTheCornersOfADentalArch) {
    const Vec3 arch(60, 45, 25);
    for (const double angle : {0.0, 0.3, 1.25, 2.8, 5.0}) {
        for (const DevicePreset& device : devicePresets()) {
            const WorkspaceFit fit = fitWorkspace(device.workspace, sizeInDeviceFrame(arch, aboutUp(angle)));
            if (!fit.coversBox) continue;
            const Vec3 corners[] = {Vec3(1, 1, 1), Vec3(-1, 1, -1), Vec3(1, -1, 1), Vec3(-1, -1, -1)};
            for (const Vec3& corner : corners) {
                const Vec3 hand = fit.motionScaling * (aboutUp(angle).conjugate() * (0.5 * corner.cwiseProduct(arch)));
                EXPECT_LE((2 * hand.cwiseAbs() - device.workspace).maxCoeff(), 1e-9) << device.name << " " << angle;
            }
        }
    }
}

TEST(WorkspaceFit, TheLimitIsNearASideOfTheWorkspaceOrOutside) {
    DeviceInfo device;
    device.workspace = Vec3(160, 70, 120);
    EXPECT_FALSE(isNearWorkspaceLimit(device, Vec3(500, 0, 0), 2)) << "the position of its workspace is not known";
    device.workspaceCentre = Vec3(10, 0, 100);
    EXPECT_FALSE(isNearWorkspaceLimit(device, Vec3(10, 0, 100), 2));
    EXPECT_FALSE(isNearWorkspaceLimit(device, Vec3(87.9, 0, 100), 2));
    EXPECT_TRUE(isNearWorkspaceLimit(device, Vec3(88.1, 0, 100), 2));
    EXPECT_TRUE(isNearWorkspaceLimit(device, Vec3(10, -33.1, 100), 2));
    EXPECT_TRUE(isNearWorkspaceLimit(device, Vec3(10, 0, 300), 2));
}

}  // namespace
}  // namespace tactooth
