// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "devices/base/haptic_device.h"
#include "geometry/util/message.h"

namespace tactooth {

/// "pen:NAME" is the pen of that name in the vendor's setup program.
inline constexpr std::string_view kNamedPen = "pen:";

/// "replay:FILE" is a hand that goes the way of a file; not openDevice opens it, but openDeviceOrReplay of the session.
inline constexpr std::string_view kReplay = "replay:";
[[nodiscard]] inline bool isReplay(const std::string& name) {
    return name.starts_with(kReplay) && name.size() > kReplay.size();
}

/// The names that checkDeviceName accepts, for help and messages, without replays: "mouse, pen, ..., pen:NAME or ...
/// for one of several". `isSecond`: see there.
[[nodiscard]] std::string deviceNames(bool isSecond = false);

/// Whether openDevice knows `name`, or it is the mouse or a replay; nothing is opened. Fails with one sentence that
/// says what `option`, of the command line or a file, takes. `isSecond`: of the other hand, which is none or no mouse.
[[nodiscard]] Expected<void> checkDeviceName(const std::string& name, const std::string& option, bool isSecond = false);

/// Opens the device that a person has named: one of deviceBackends() but the mouse. "pen" is the default pen of
/// OpenHaptics, "pen:NAME" the one of that name in the vendor's setup program; "gamepad" the first gamepad,
/// "gamepad:NAME" the first whose name holds NAME; "inverse3" the first Haply Inverse3, "inverse3:ID" the one of that
/// name. Fails with one sentence that says what to do. May take seconds. `leftHanded`: for devices that are not the
/// same for both hands. `rateHz`: for devices whose driver paces the servo.
[[nodiscard]] Expected<std::unique_ptr<HapticDevice>> openDevice(const std::string& name, bool leftHanded = false,
                                                                 double rateHz = 1000);

}  // namespace tactooth
