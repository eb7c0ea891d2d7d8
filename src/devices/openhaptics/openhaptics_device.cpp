// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/openhaptics/openhaptics_device.h"

#include <limits>

#include "devices/base/messages.h"
#include "devices/base/monotonic_clock.h"
#include "devices/base/timed_wait.h"
#include "devices/openhaptics/hd_driver.h"

namespace tactooth {
namespace {

constexpr double kLongestSilence = 2.5;  // ticks: two are missing, so the pen counts as lost
constexpr double kMaxBent = 0.01;        // tolerance of the axes' lengths and of the cosines between them
constexpr double kLongestStart = 0.5;    // s for the first reading to arrive; before it the device is not silent
const Message kSilent(msg::kHdSilent);

// HDAPI: +x right, +y up, +z toward the user. Here: +x right, +y away from the user, +z up.
Vec3 fromHd(const Vec3& v) { return {v.x(), -v.z(), v.y()}; }
Vec3 toHd(const Vec3& v) { return {v.x(), v.z(), -v.y()}; }

/// Rotation of the three axes. Axes that are not orthonormal and right-handed give four zeros, which later checks
/// recognise as no rotation: a conversion of a distorted matrix would give some arbitrary rotation.
Quat rotationOf(const Eigen::Matrix3d& axes) {
    if (!axes.allFinite()) return {std::numeric_limits<double>::quiet_NaN(), 0, 0, 0};
    const double bent = (axes.transpose() * axes - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (bent > kMaxBent || axes.determinant() < 0) return {0, 0, 0, 0};
    return Quat(axes).normalized();
}

Pose poseOf(const std::array<double, 16>& transform) {
    Eigen::Matrix3d rotation;
    for (int column = 0; column < 3; ++column) {
        const double* const axis = &transform[static_cast<std::size_t>(4 * column)];
        rotation.col(column) = fromHd(Vec3(axis[0], axis[1], axis[2]));
    }
    return {fromHd(Vec3(transform[12], transform[13], transform[14])), rotationOf(rotation)};
}

}  // namespace

OpenHapticsDevice::OpenHapticsDevice(std::string device, std::string library, double rateHz)
    : name_(std::move(device)), library_(std::move(library)), rateHz_(rateHz) {
    info_.name = "OpenHaptics pen";
    info_.rendersForce = info_.sensesRotation = true;
    info_.buttonCount = 2;
}

OpenHapticsDevice::~OpenHapticsDevice() { close(); }

Expected<void> OpenHapticsDevice::open() {
    close();
    auto driver = HdDriver::shared(library_, rateHz_);
    if (!driver) return Unexpected{driver.error()};
    const Expected<HdPen*> pen = (*driver)->start(name_, info_, sampleListener());
    if (!pen) return Unexpected{pen.error()};
    driver_ = std::move(*driver);
    pen_ = *pen;
    hasReading_ = false;
    silence_ = 0;
    return {};
}

void OpenHapticsDevice::close() {
    if (pen_ == nullptr) return;
    pen_->force.write(Vec3::Zero());
    driver_->stop(*pen_);
    pen_ = nullptr;
    driver_.reset();
}

void OpenHapticsDevice::waitForTick(double longest) {
    waitForSemaphore(pen_->ready, longest);
    while (sem_trywait(&pen_->ready) == 0) {  // readings that arrived while the last one was processed
    }
}

DeviceSample OpenHapticsDevice::read(double elapsed) {
    const bool isFresh = pen_->reading.refresh();
    hasReading_ |= isFresh;
    silence_ = isFresh ? 0 : silence_ + elapsed;
    const HdReading& reading = pen_->reading.value();
    const bool silent = silence_ > (hasReading_ ? kLongestSilence / rateHz_ : kLongestStart);
    silent_.store(silent, std::memory_order_relaxed);
    DeviceSample sample;
    sample.connected = hasReading_ && !silent && reading.calibrated && !pen_->lost.load(std::memory_order_relaxed);
    sample.hand = poseOf(reading.transform);
    sample.buttons = reading.buttons;
    sample.motorTemperature = reading.motorTemperature;
    sample.age = reading.time > 0 ? monotonicSeconds() - reading.time : 0;
    sample.isFresh = isFresh;
    return sample;
}

void OpenHapticsDevice::write(const SafeWrench& wrench) { pen_->force.write(toHd(wrench.force())); }

const Message* OpenHapticsDevice::faultMessage() const {
    if (pen_ == nullptr) return nullptr;
    if (const Message* const fault = pen_->faultMessage.load(std::memory_order_relaxed)) return fault;
    return silent_.load(std::memory_order_relaxed) ? &kSilent : HapticDevice::faultMessage();
}

}  // namespace tactooth
