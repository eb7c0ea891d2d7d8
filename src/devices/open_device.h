// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "devices/base/haptic_device.h"
#include "geometry/util/message.h"

namespace tactooth {

/// "replay:FILE" is a device that follows the trajectory of a file. openDevice does not open it; openDeviceOrReplay of
/// the session does.
inline constexpr std::string_view kReplay = "replay:";
[[nodiscard]] inline bool isReplay(const std::string& name) {
    return name.starts_with(kReplay) && name.size() > kReplay.size();
}

/// The names that checkDeviceName accepts, for help and messages, without replays: "mouse, pen, ..., pen:NAME or ...
/// for one of several". `isSecond`: see checkDeviceName.
[[nodiscard]] std::string deviceNames(bool isSecond = false);

/// Checks whether openDevice knows `name`, or it is the mouse or a replay; opens nothing. Fails with one sentence that
/// lists the values of `option`, an option of the command line or an entry of a file. `isSecond`: the device is for the
/// second hand, where "none" is allowed and the mouse is not.
[[nodiscard]] Expected<void> checkDeviceName(const std::string& name, const std::string& option, bool isSecond = false);

/// Where a device's link runs.
enum class DeviceHost {
    HandProcess,  ///< in tactooth-hand, which cuts the force if this program fails
    ThisProcess,  ///< for debugging
};
/// For all devices that are opened from now on; call it while the program has one thread. Without a call it is
/// HandProcess, unless the variable TACTOOTH_DEVICE_IN_PROCESS is set to 1.
void setDeviceHost(DeviceHost host);
[[nodiscard]] DeviceHost deviceHost();

/// Opens the device that the user has named: one of deviceBackends() except the mouse. "pen" is the default pen of
/// OpenHaptics, "pen:NAME" the one with that name in the vendor's setup program. "gamepad" is the first gamepad,
/// "gamepad:NAME" the first whose name contains NAME. "inverse3" is the first Haply Inverse3, "inverse3:ID" the one
/// with that name. Fails with one sentence that states the remedy. May take seconds. `leftHanded`: for devices that
/// differ between left and right hand. `rateHz`: for devices whose driver sets the servo rate.
[[nodiscard]] Expected<std::unique_ptr<HapticDevice>> openDevice(const std::string& name, bool leftHanded = false,
                                                                 double rateHz = 1000);

/// The same in this process, whatever deviceHost() is. The device calls `listener`.
[[nodiscard]] Expected<std::unique_ptr<HapticDevice>> openDeviceInProcess(const std::string& name, bool leftHanded,
                                                                          double rateHz,
                                                                          const SampleListener& listener = {});

}  // namespace tactooth
