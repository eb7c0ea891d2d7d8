// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/simulated/simulated_driver.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "devices/base/monotonic_clock.h"
#include "standin/plane_servo.h"

namespace tactooth {
namespace {

using test::soon;

TEST(SimulatedDriver, SetsThePaceOfItsServoAndTimesItsAnswers) {
    SimulatedDriver driver(1000);
    ASSERT_TRUE(driver.open());
    const test::PlaneServo servo(driver);
    double took = 0;                // s for 300 ticks
    const auto isAtItsPace = [&] {  // a machine that stalls now and then leaves it some time in between
        const long before = servo.ticks();
        const std::uint64_t answers = driver.responseTime().total();
        const double start = monotonicSeconds();
        if (!soon([&] { return servo.ticks() > before + 300; })) return false;
        took = monotonicSeconds() - start;
        return std::abs(took - 0.3) < 0.2 && driver.responseTime().total() > answers + 250;
    };
    EXPECT_TRUE(soon(isAtItsPace)) << took;
    EXPECT_LT(driver.responseTime().quantile(0.5), 1000);
}

TEST(SimulatedDriver, NotifiesItsListenerOfEachSample) {
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
