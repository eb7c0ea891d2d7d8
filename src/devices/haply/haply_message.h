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

// The messages of the Haply Inverse Service, format 3: JSON text over a WebSocket on this machine. Its first message
// tells of all devices; after that each message that it gets is answered by one. On the wire: m, N, unit quaternions;
// +x right, +y away from the user, +z up, as here.

/// Which Inverse3 is meant, and the grip that the same hand holds.
struct HaplyNames {
    std::string device;  ///< four letters and digits, as the service gives them
    std::string grip;    ///< of a VerseGrip; empty: there is none
};

/// One Inverse3 with its grip at one moment.
struct HaplyReading {
    Pose hand;             ///< mm; where `hasTurn` is false it is not turned
    bool hasTurn = false;  ///< a grip tells how it is turned
    std::uint32_t buttons = 0;
    bool usable = true;                     ///< false: the place is not known, or the device makes no force
    const Message* faultMessage = nullptr;  ///< what is wrong and what to do about it; lives as long as the program
    double time = 0;                        ///< s of the monotonic clock; filled in by whoever has a clock
};

/// All devices of the service's first message, in its order; at least one. The n-th Inverse3 goes with the n-th
/// VerseGrip, those with a cable first. Fails with one sentence that says what to do.
[[nodiscard]] Expected<std::vector<HaplyNames>> haplyDevices(std::string_view firstMessage);

/// The one called `wanted`, or the first if that is empty.
[[nodiscard]] Expected<HaplyNames> findHaply(std::string_view firstMessage, std::string_view wanted);

/// What any message says of a device. Fails with one sentence if it is no JSON, of another version, or does not speak
/// of the device; what the message says is never trusted to be a number or near.
[[nodiscard]] Expected<HaplyReading> readHaply(std::string_view message, const HaplyNames& names);

/// The message that asks for a force, N. Also a zero force has to be sent: the service answers only what it is asked.
[[nodiscard]] std::string haplyForce(const std::string& device, const Vec3& force);

/// The first message of a session, which tells the service who is there.
[[nodiscard]] std::string haplyHandshake(const std::string& device);

}  // namespace tactooth
