// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Pose faults of a device while the tool presses on a block of enamel. The test has its own clock, so a busy machine
// has no effect.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "devices/base/device_presets.h"
#include "haptics/haptic_simulation.h"
#include "session/control/device_set.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

constexpr double kPressed = -1;        // mm: device position inside the block
constexpr double kKnowable = 0.005;    // s from the first wrong reading to zero force
constexpr double kContactForce = 0.2;  // N
const double kNan = std::nan("");

std::shared_ptr<const Surface> block() {
    const std::vector<SurfaceTag> tags(12, static_cast<SurfaceTag>(test::kEnamel));
    auto surface = std::make_shared<Surface>();
    surface->base = std::make_shared<const SurfacePart>(test::box(Vec3(-50, -50, -5), Vec3(50, 50, 0)), tags);
    return surface;
}

/// A device whose pose the test sets; from the start of a fault on it reports another pose.
class FaultyDevice final : public HapticDevice {
public:
    /// `tick`: ticks since the fault began, from 1 on; `time`: the same in s.
    using Fault = std::function<void(DeviceSample&, int tick, double time)>;

    explicit FaultyDevice(const DevicePreset& preset) {
        info_.rendersForce = info_.sensesRotation = true;
        info_.limits = limitsOf(preset);
        info_.stiffness = preset.stiffness;
    }
    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override { return {}; }
    void close() override {}
    [[nodiscard]] DeviceSample read(double elapsed) override {
        DeviceSample sample = hand;
        if (fault) ++ticks, fault(sample, ticks, ticks * elapsed);
        return sample;
    }
    void write(const SafeWrench& wrench) override { force = wrench.force(); }

    DeviceSample hand;
    Fault fault;
    int ticks = 0;  // since the fault began; the first one already has a wrong reading
    Vec3 force = Vec3::Zero();

private:
    DeviceInfo info_;
};

/// A device over a block of enamel, tick by tick.
class Bench {
public:
    Bench(const DevicePreset& preset, double rateHz)
        : device(preset),
          hands(device, nullptr, std::nullopt),
          simulation(std::make_shared<const ToolShape>(test::sphere(Vec3(0, 0, 0.5), 0.5, 24, 12)), 0.5, block(),
                     HapticSettings()),
          dt_(1 / rateHz) {}

    void run(double seconds) {
        for (const double end = time_ + seconds - 0.5 * dt_; time_ < end;) tick();
    }
    void tick() {
        hands.read(dt_, {});
        simulation.force().setMaxStiffness(maxStiffnessAt(hands.maxStiffness(), 1 / dt_));
        last = simulation.step({hands.turbine(), cutting ? 1.0 : 0.0, cutting}, dt_);
        hands.write(last, true, dt_);
        time_ += dt_;
        strongest = std::max(strongest, device.force.norm());
        finite = finite && device.force.allFinite() && last.contact.proxy.position.allFinite();
    }
    /// Moves the device down onto the block at 0.1 m/s, after a jump to 1 mm above it.
    void press() {
        device.hand.hand.position = Vec3(0, 0, 1);
        run(0.3);
        while (device.hand.hand.position.z() > kPressed) {
            device.hand.hand.position.z() -= 100 * dt_;
            tick();
        }
        run(0.7);
    }
    [[nodiscard]] double dt() const { return dt_; }

    FaultyDevice device;
    DeviceSet hands;
    HapticSimulation simulation;
    Tick last;
    bool cutting = false;
    double strongest = 0;
    bool finite = true;

private:
    double dt_;
    double time_ = 0;
};

struct Case {
    const char* name;
    const char* sentence;  ///< nullptr: the device reports the fault itself
    FaultyDevice::Fault fault;
};

double odd(int tick, double value) { return tick % 2 == 1 ? value : 0; }

void turnBy(DeviceSample& sample, double angle) {
    sample.hand.rotation = Quat(Eigen::AngleAxisd(angle, Vec3::UnitY())) * sample.hand.rotation;
}

const Case kCases[] = {
    {"Lost", nullptr, [](DeviceSample& s, int, double) { s.connected = false; }},
    {"NanPlace", "is not a number", [](DeviceSample& s, int, double) { s.hand.position.y() = kNan; }},
    {"InfinitePlace", "is not a number",
     [](DeviceSample& s, int, double) { s.hand.position.z() = -std::numeric_limits<double>::infinity(); }},
    {"FarPlace", "position has jumped", [](DeviceSample& s, int, double) { s.hand.position.x() = 1e30; }},
    {"NanTurn", "is not a number", [](DeviceSample& s, int, double) { s.hand.rotation.x() = kNan; }},
    {"ZeroTurn", "orientation that is not valid",
     [](DeviceSample& s, int, double) { s.hand.rotation.coeffs().setZero(); }},
    {"LongTurn", "orientation that is not valid",
     [](DeviceSample& s, int, double) { s.hand.rotation.coeffs() *= 1.05; }},
    {"ShortTurn", "orientation that is not valid",
     [](DeviceSample& s, int, double) { s.hand.rotation.coeffs() *= 0.7; }},
    {"TurnOnce", "orientation has jumped", [](DeviceSample& s, int, double) { turnBy(s, 1); }},
    {"TurnToAndFro", "orientation has jumped", [](DeviceSample& s, int tick, double) { turnBy(s, odd(tick, 0.3)); }},
    {"TurnOver", "orientation has jumped", [](DeviceSample& s, int tick, double) { turnBy(s, odd(tick, 3.1)); }},
    {"Spin", "orientation has jumped", [](DeviceSample& s, int tick, double) { turnBy(s, 0.2 * tick); }},
    {"Jump50", "position has jumped", [](DeviceSample& s, int tick, double) { s.hand.position.x() += odd(tick, 50); }},
    {"JumpOnce", "position has jumped", [](DeviceSample& s, int, double) { s.hand.position.x() += 7; }},
    {"Jitter4.9", "position has jumped",
     [](DeviceSample& s, int tick, double) { s.hand.position.x() += odd(tick, 4.9); }},
    {"JitterInAndOut", "position has jumped",
     [](DeviceSample& s, int tick, double) { s.hand.position.z() += odd(tick, 4.9); }},
    {"JitterDeeper", "position has jumped",
     [](DeviceSample& s, int tick, double) { s.hand.position.z() -= odd(tick, 2.2); }},
    {"Drift", "", [](DeviceSample& s, int, double time) { s.hand.position.x() += std::min(40.0, 3000 * time); }},
    {"DriftDown", "", [](DeviceSample& s, int, double time) { s.hand.position.z() -= std::min(40.0, 3000 * time); }},
    {"Stale", "come too late",
     [](DeviceSample& s, int tick, double) {
         s.age = 0.0051 + 1e-3 * tick;
         s.isFresh = false;
     }},
    {"AgeIsNoNumber", "come too late", [](DeviceSample& s, int, double) { s.age = kNan; }},
    {"HeatIsNoNumber", "was not a number, so the force is off",
     [](DeviceSample& s, int, double) { s.motorTemperature = kNan; }},
};

class DeviceFaults : public ::testing::TestWithParam<std::tuple<Case, double>> {};

TEST_P(DeviceFaults, MidPressEndTheForceInTimeAndItComesBackWhenTheBurHasBeenFree) {
    const auto& [fault, rateHz] = GetParam();
    Bench bench(*findDevicePreset("touch"), rateHz);
    bench.press();
    ASSERT_GT(bench.device.force.norm(), kContactForce);
    bench.device.fault = fault.fault;
    double lastForce = 0;  // s after the first wrong reading
    for (int i = 1; i * bench.dt() < 0.3; ++i) {
        bench.tick();
        if (!bench.device.force.isZero(0)) lastForce = i * bench.dt();
        if (i * bench.dt() < 0.1) {
            EXPECT_LT((bench.last.contact.proxy.position - Vec3(0, 0, 0)).norm(), 2.5)
                << "the tool stays about where it is";
        }
    }
    EXPECT_LE(lastForce, kKnowable);
    RecordProperty("last_force_ms", std::to_string(1e3 * lastForce));
    if (fault.sentence != nullptr) {
        ASSERT_NE(bench.device.faultMessage(), nullptr);
        EXPECT_THAT(bench.device.faultMessage()->in(Language::English), HasSubstr(fault.sentence));
    }
    EXPECT_NE(bench.hands.forceState(), ForceState::On) << "what stays where it has jumped to is believed at last";
    bench.device.fault = nullptr;
    bench.run(0.5);
    EXPECT_EQ(bench.device.force, Vec3::Zero()) << "nobody is kicked: the bur is in the block still";
    bench.press();
    EXPECT_GT(bench.device.force.norm(), kContactForce) << "the same device goes on";
    EXPECT_LE(bench.strongest, bench.device.info().limits.force);
    EXPECT_TRUE(bench.finite);
}

INSTANTIATE_TEST_SUITE_P(All, DeviceFaults,
                         ::testing::Combine(::testing::ValuesIn(kCases), ::testing::Values(500.0, 1000.0, 4000.0)),
                         [](const auto& one) {
                             std::string name = std::get<0>(one.param).name;
                             std::erase(name, '.');
                             return name + "At" + std::to_string(static_cast<int>(std::get<1>(one.param))) + "Hz";
                         });

TEST(DeviceFaultsNone, AQuaternionThatChangesItsSignsChangesNoForce) {
    Bench bench(*findDevicePreset("touch"), 1000);
    bench.press();
    const Vec3 force = bench.device.force;
    bench.device.fault = [](DeviceSample& sample, int tick, double) {
        if (tick % 2 == 1) sample.hand.rotation.coeffs() *= -1;
    };
    bench.run(0.5);
    EXPECT_LT((bench.device.force - force).norm(), 1e-6);
    EXPECT_EQ(bench.device.faultMessage(), nullptr);
}

TEST(DeviceFaultsNone, AReadingThatIsSeenAgainAndAgainIsNoneForAsLongAsItIsYoung) {
    Bench bench(*findDevicePreset("touch"), 4000);
    bench.press();
    bench.device.fault = [](DeviceSample& sample, int tick, double) {
        sample.isFresh = tick % 4 == 0;
        sample.age = 0.00025 * (tick % 4);
    };
    bench.run(0.5);
    EXPECT_GT(bench.device.force.norm(), 0.3);
    EXPECT_EQ(bench.device.faultMessage(), nullptr);
}

TEST(DeviceFaultsNone, WhileAPoseIsAtFaultNothingIsCut) {
    Bench bench(*findDevicePreset("touch"), 1000);
    bench.cutting = true;
    bench.press();
    ASSERT_GT(bench.last.spindle.cutWork, 0);
    bench.device.fault = [](DeviceSample& sample, int tick, double) { sample.hand.position.x() += odd(tick, 4.9); };
    bench.run(0.01);
    const double work = bench.last.spindle.cutWork;
    bench.run(1);
    EXPECT_NEAR(bench.last.spindle.cutWork, work, 1e-6);
}

/// A device that moves into the block and out again, and that now and then has an arbitrary fault while it presses, for
/// up to 90 ms. This is shorter than the time after which a jumped position is accepted.
TEST(DeviceFaultsMixed, NoMixtureOfFaultsMakesAForceThatIsLateTooStrongOrNoNumber) {
    std::mt19937 random(20261125);
    Bench bench(*findDevicePreset("touch"), 1000);
    long strong = 0;
    int left = 0;
    for (int tick = 0; tick < 200'000; ++tick) {
        const double z = 0.4 - 1.2 * std::sin(0.004 * tick);
        bench.device.hand.hand.position = Vec3(0.3 * std::sin(0.001 * tick), 0, z);
        if (left == 0 && bench.last.contact.triangles > 0 && random() % 400 == 0) {
            bench.device.fault = kCases[random() % std::size(kCases)].fault;
            bench.device.ticks = 0;
            left = 1 + static_cast<int>(random() % 90);
        }
        bench.tick();
        if (left > 0) {
            ASSERT_TRUE(bench.device.ticks <= 2 || bench.device.force.isZero(0)) << tick;
            if (--left == 0) bench.device.fault = nullptr;
        }
        strong += bench.device.force.norm() > 0.1;
        ASSERT_TRUE(bench.finite) << tick;
        ASSERT_LE(bench.device.force.norm(), 3.3 + 1e-12) << tick;
    }
    EXPECT_GT(strong, 20'000) << "the sample means something";
}

}  // namespace
}  // namespace tactooth
