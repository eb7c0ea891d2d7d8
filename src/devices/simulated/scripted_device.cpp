// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/simulated/scripted_device.h"

#include <utility>

#include "geometry/util/assert.h"

namespace tactooth {

ScriptedDevice::ScriptedDevice(std::vector<DeviceKeyframe> script, std::string name, bool isInToothFrame)
    : script_(std::move(script)) {
    TACTOOTH_ASSERT(!script_.empty());
    info_.name = std::move(name);
    info_.poseLimits = PoseLimits::unlimited();
    info_.isInToothFrame = isInToothFrame;
    info_.rendersForce = info_.sensesRotation = info_.hasPedal = true;
    info_.buttonCount = 2;
    time_ = script_.front().time;
}

Expected<void> ScriptedDevice::open() {
    next_ = 0;
    time_ = script_.front().time;
    return {};
}

DeviceSample ScriptedDevice::read(double elapsed) {
    time_ += elapsed;
    while (next_ < script_.size() && script_[next_].time <= time_) ++next_;
    if (next_ == script_.size()) return script_.back().sample;
    if (next_ == 0) return script_.front().sample;
    const DeviceKeyframe& before = script_[next_ - 1];
    const DeviceKeyframe& after = script_[next_];
    const double part = (time_ - before.time) / (after.time - before.time);
    DeviceSample sample = before.sample;
    sample.hand.position += part * (after.sample.hand.position - before.sample.hand.position);
    sample.hand.rotation = before.sample.hand.rotation.slerp(part, after.sample.hand.rotation).normalized();
    sample.pedal += part * (after.sample.pedal - before.sample.pedal);
    return sample;
}

}  // namespace tactooth
