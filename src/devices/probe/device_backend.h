// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "devices/base/haptic_device.h"
#include "devices/probe/detected_device.h"
#include "geometry/util/message.h"

namespace tactooth {

/// A device as the user requests it.
struct DeviceRequest {
    std::string unit;  ///< the text after the colon of "pen:NAME": one of several; empty: the first or default one
    bool leftHanded = false;  ///< for devices that differ between left and right hand
    double rateHz = 1000;     ///< for devices whose driver sets the servo rate
};

/// A kind of device. Each backend defines one row; device_registry.cpp lists the rows. The command line, the device
/// panel, 'tactooth devices' and 'tactooth doctor' all use that list.
struct DeviceBackend {
    const char* name;          ///< value for --device, before the colon
    const MessageText& title;  ///< display name
    const char* unitWord;      ///< name of the text after the colon in the help ("NAME", "ID"); nullptr: takes none
    /// Creates the device without opening it; never returns nullptr. The pointer itself is nullptr for the mouse, which
    /// needs no opening.
    std::unique_ptr<HapticDevice> (*create)(const DeviceRequest& request);
    /// A trial before the device is opened for the first time; it keeps a broken driver out of this process. nullptr:
    /// none is needed.
    Expected<void> (*trial)();
    /// The devices of this kind that are present, or one entry with the reason why there is none.
    std::vector<DetectedDevice> (*probe)();
    /// The names of several devices of this kind, as the user has set them up: the text after the colon. Without the
    /// default one. nullptr: they have no names.
    std::vector<std::string> (*units)() = nullptr;
    const MessageText* unitTitle = nullptr;  ///< display name of one of these; %1: its name
};

/// All kinds, in display order; the mouse comes first.
[[nodiscard]] std::span<const DeviceBackend> deviceBackends();
/// The kind of that name; nullptr if there is none.
[[nodiscard]] const DeviceBackend* findDeviceBackend(const std::string& name);

}  // namespace tactooth
