// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/simulated/simulated_device.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/util/assert.h"

// Semi-implicit Euler integration. In each step dry friction reduces the speed by as much as its bound allows, so that
// a pen held by friction stands still (J. Bender, K. Erleben, J. Trinkle, "Interactive Simulation of Rigid Body
// Dynamics in Computer Graphics", Computer Graphics Forum 33, 2014, section 4.2: an impulse within the friction's
// bound).

namespace tactooth {
namespace {

constexpr double kLongestStep = 5e-5;  // s: a hundredth of the shortest period, that of 50 g on 3 N/mm
// Hz, without a common ratio, around the 8 to 12 Hz of a hand's tremor.
constexpr std::array<double, 3> kTremor = {8.1, 9.7, 11.3};

double rounded(double value, double step) { return step > 0 ? std::round(value / step) * step : value; }

}  // namespace

SimulatedDevice::SimulatedDevice(const DevicePreset& device, const HandImpedance& hand,
                                 std::vector<DeviceKeyframe> script, const OperatorBehaviour& habits)
    : device_(device),
      hand_(hand),
      behaviour_(habits),
      reference_(std::move(script)),
      lastCommand_(reference_.read(0).hand.position),
      tip_(lastCommand_) {
    TACTOOTH_ASSERT(device.delayTicks >= 0 && device.delayTicks <= kMaxDelay);
    info_ = reference_.info();
    info_.name = std::string(device.title) + " (simulated)";
    info_.limits = limitsOf(device);
    info_.poseLimits = PoseLimits();
    info_.stiffness = device.stiffness;
    info_.workspace = device.workspace;
    forces_.fill(Vec3::Zero());
}

Expected<void> SimulatedDevice::open() {
    (void)reference_.open();
    time_ = 0;
    lastCommand_ = tip_ = reference_.read(0).hand.position;
    speed_.setZero();
    forces_.fill(Vec3::Zero());
    return {};
}

Vec3 SimulatedDevice::tremorOffset(double time) const {
    Vec3 sines;
    for (int axis = 0; axis < 3; ++axis) {
        sines[axis] = std::sin(2 * std::numbers::pi * kTremor[static_cast<std::size_t>(axis)] * time);
    }
    return behaviour_.tremor * std::sqrt(2.0 / 3) * sines;  // the mean square of each sine is one half
}

void SimulatedDevice::move(const Vec3& wanted, const Vec3& wantedSpeed, const Vec3& force, double dt) {
    const bool held = time_ < behaviour_.releaseTime;
    const double mass = device_.inertia + (held ? hand_.mass : 0);
    Vec3 push = force - device_.damping * speed_;
    if (held) push += hand_.stiffness * (wanted - tip_) + hand_.damping * (wantedSpeed - speed_);
    speed_ += dt / mass * push;
    const double taken = device_.friction * dt / mass;
    const double left = speed_.norm() - taken;
    speed_ = left > 0 ? Vec3(speed_ * (left / (left + taken))) : Vec3::Zero();
    tip_ += dt * speed_;
}

DeviceSample SimulatedDevice::read(double elapsed) {
    DeviceSample sample = reference_.read(elapsed);
    if (elapsed > 0) {
        const int steps = std::max(1, static_cast<int>(std::ceil(elapsed / kLongestStep)));
        const double dt = elapsed / steps;
        const Vec3 start = lastCommand_;
        const Vec3 end = sample.hand.position + tremorOffset(time_ + elapsed);
        const Vec3& force = forces_[static_cast<std::size_t>(device_.delayTicks)];
        for (int i = 1; i <= steps; ++i) {
            move(start + (end - start) * (double(i) / steps), (end - start) / elapsed, force, dt);
            time_ += dt;
        }
        lastCommand_ = end;
    }
    sample.hand.position = tip_.unaryExpr([&](double x) { return rounded(x, device_.encoderStep); });
    return sample;
}

void SimulatedDevice::write(const SafeWrench& wrench) {
    std::shift_right(forces_.begin(), forces_.end(), 1);
    forces_.front() = wrench.force();
}

}  // namespace tactooth
