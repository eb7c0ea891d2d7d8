// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/util/expected.h"
#include "geometry/util/pose.h"

namespace tactooth {

// The messages of the Haply Inverse Service, format 3: JSON text over a WebSocket on this machine. The service's first
// message lists all devices; afterwards it answers each message that it receives with one message. Units on the wire:
// m, N, unit quaternions; axes +x right, +y away from the user, +z up, as in this program.

/// Identifies an Inverse3 and the grip in the same hand.
struct HaplyNames {
    std::string device;  ///< four letters and digits, as the service reports them
    std::string grip;    ///< name of a VerseGrip; empty: there is none
};

/// Reading of one Inverse3 and its grip at one moment.
struct HaplyReading {
    Pose hand;             ///< mm; without a rotation if `hasTurn` is false
    bool hasTurn = false;  ///< a grip has reported its rotation
    std::uint32_t buttons = 0;
    bool usable = true;                     ///< false: the position is unknown, or the device renders no force
    const Message* faultMessage = nullptr;  ///< the fault and its remedy; lives as long as the program
    double time = 0;  ///< s of the monotonic clock; set by the caller, because the parser has no clock
};

/// All devices of the service's first message, in its order; at least one. The n-th Inverse3 is paired with the n-th
/// VerseGrip; grips with a cable come first. Fails with one sentence that states the remedy.
[[nodiscard]] Expected<std::vector<HaplyNames>> haplyDevices(std::string_view firstMessage);

/// The device named `wanted`, or the first if that is empty.
[[nodiscard]] Expected<HaplyNames> findHaply(std::string_view firstMessage, std::string_view wanted);

/// The reading of a device from any message. Fails with one sentence if the message is not JSON, has another version or
/// does not contain the device. Numbers in the message are never trusted to be finite or in range.
[[nodiscard]] Expected<HaplyReading> readHaply(std::string_view message, const HaplyNames& names);

/// The message that requests a force, N. A zero force has to be sent too: the service answers only messages that it
/// receives.
[[nodiscard]] std::string haplyForce(const std::string& device, const Vec3& force);

/// The first message to the service in a session; it identifies this program and requests a zero force.
[[nodiscard]] std::string haplyHandshake(const std::string& device);

}  // namespace tactooth
