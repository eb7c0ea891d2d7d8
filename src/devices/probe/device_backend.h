// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "devices/base/device_presets.h"
#include "devices/base/haptic_device.h"
#include "devices/probe/detected_device.h"
#include "geometry/util/message.h"

namespace tactooth {

/// What a person has asked for.
struct DeviceRequest {
    std::string unit;         ///< behind the colon of "pen:NAME": one of several; empty: the first or default one
    bool leftHanded = false;  ///< for devices that are not the same for both hands
    double rateHz = 1000;     ///< for devices whose driver paces the servo
};

/// A kind of device. Each backend defines one row; device_registry.cpp lists the rows. The command line, the device
/// panel, 'tactooth devices' and 'tactooth doctor' all read that list.
struct DeviceBackend {
    const char* name;          ///< as --device takes it, before the colon
    const MessageText& title;  ///< for people
    const char* unitWord;      ///< what the help calls the text behind the colon ("NAME", "ID"); nullptr: takes none
    /// Makes the device without opening it; never nullptr. Function pointer nullptr: the mouse, which needs no opening.
    std::unique_ptr<HapticDevice> (*create)(const DeviceRequest& request);
    /// A trial before the first opening that keeps a broken driver out of this process; nullptr: none is needed.
    Expected<void> (*trial)();
    /// The devices of this kind that are there, or one entry that says why none is.
    std::vector<DetectedDevice> (*probe)();
    std::span<const DevicePreset> presets;  ///< mechanics of its models, for simulated devices and force limits
};

/// All kinds, in the order in which people see them; the mouse comes first.
[[nodiscard]] std::span<const DeviceBackend> deviceBackends();
/// The kind of that name; nullptr if there is none.
[[nodiscard]] const DeviceBackend* findDeviceBackend(const std::string& name);

}  // namespace tactooth
