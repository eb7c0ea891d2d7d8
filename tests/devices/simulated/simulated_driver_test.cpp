// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/simulated/simulated_driver.h"

#include <gtest/gtest.h>

#include <atomic>

#include "devices/base/monotonic_clock.h"
#include "standin/plane_servo.h"

namespace tactooth {
namespace {

using test::soon;

TEST(SimulatedDriver, SetsThePaceOfItsServoAndTimesItsAnswers) {
    SimulatedDriver driver(1000);
    ASSERT_TRUE(driver.open());
    const test::PlaneServo servo(driver);
    const long before = servo.ticks();
    const double start = monotonicSeconds();
    ASSERT_TRUE(soon([&] { return servo.ticks() > before + 300; }));
    EXPECT_NEAR(monotonicSeconds() - start, 0.3, 0.2);
    EXPECT_GT(driver.responseTime().total(), 250U);
    EXPECT_LT(driver.responseTime().quantile(0.5), 1000);
}

TEST(SimulatedDriver, TellsItsListenerOfEachSample) {
    SimulatedDriver driver(1000);
    std::atomic<int> samples{0};
    driver.setSampleListener({[](void* count) { ++*static_cast<std::atomic<int>*>(count); }, &samples});
    ASSERT_TRUE(driver.open());
    EXPECT_TRUE(soon([&] { return samples > 100; }));
    DeviceSample sample = driver.read(0.1);
    EXPECT_TRUE(sample.connected && sample.isFresh);
    driver.close();
    const int atTheEnd = samples;
    (void)driver.read(0);
    sample = driver.read(0);
    EXPECT_FALSE(sample.isFresh);
    EXPECT_EQ(samples, atTheEnd);
}

}  // namespace
}  // namespace tactooth
