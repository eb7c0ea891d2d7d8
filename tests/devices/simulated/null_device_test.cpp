// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/simulated/null_device.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(NullDevice, RestsWhereItWasPutAndRendersNoForce) {
    const Pose rest{Vec3(1, 2, 3), Quat(Eigen::AngleAxisd(0.5, Vec3::UnitX()))};
    NullDevice device(rest);
    EXPECT_FALSE(device.info().rendersForce);
    for (int i = 0; i < 3; ++i) {
        const DeviceSample sample = device.read(0.001);
        EXPECT_EQ(sample.hand.position, rest.position);
        EXPECT_EQ(sample.hand.rotation.coeffs(), rest.rotation.coeffs());
        EXPECT_EQ(sample.pedal, 0);
        EXPECT_EQ(sample.buttons, 0U);
    }
}

}  // namespace
}  // namespace tactooth
