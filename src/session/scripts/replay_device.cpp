// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/scripts/replay_device.h"

#include <filesystem>

#include "devices/open_device.h"
#include "devices/simulated/scripted_device.h"
#include "session/scripts/trajectory.h"

namespace tactooth {
namespace {

Expected<std::unique_ptr<HapticDevice>> openReplay(const std::filesystem::path& file) {
    const Expected<std::vector<TimedPose>> trajectory = readTrajectory(file);
    if (!trajectory) return Unexpected{trajectory.error()};
    std::vector<DeviceKeyframe> script;
    script.reserve(trajectory->size());
    for (const TimedPose& row : *trajectory) script.push_back({row.time, {row.toolInTooth, 0, 0, true}});
    auto device = std::make_unique<ScriptedDevice>(std::move(script), file.filename().string(), true);
    if (const auto opened = device->open(); !opened) return Unexpected{opened.error()};
    return std::unique_ptr<HapticDevice>(std::move(device));
}

}  // namespace

Expected<std::unique_ptr<HapticDevice>> openDeviceOrReplay(const std::string& name, bool leftHanded, double rateHz) {
    if (isReplay(name)) return openReplay(name.substr(kReplay.size()));
    return openDevice(name, leftHanded, rateHz);
}

}  // namespace tactooth
