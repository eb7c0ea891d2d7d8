// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "geometry/util/message.h"

namespace tactooth {

/// Why the hand process has cut the force, or why it is gone itself. The numbers are part of HandLink's layout.
enum class HandFault : std::uint32_t {
    None,
    // The hand process finds these.
    NoForce,         ///< no fresh force for 3 ms: the program is late or hangs
    ProgramStopped,  ///< the same, and the system says that the program is stopped
    ProgramEnded,    ///< the program has ended without closing the device
    NotANumber,      ///< a force that is not a number
    BeyondLimits,    ///< a force that the program's own limiter would not let through
    WrongSequence,   ///< a force that is out of its order, or half written
    HandHangs,       ///< the hand process: its loop has stood still, so it has ended itself
    // The program finds these.
    HandKilled,   ///< the hand process was ended by a signal
    HandStopped,  ///< it was stopped, so the program has ended it
    HandEnded,    ///< it has ended by itself
};

/// The name of a cause in the fault log: "no_force".
[[nodiscard]] std::string_view nameOf(HandFault fault);
/// A few words for people: "no fresh force for 3 ms".
[[nodiscard]] const MessageText& textOf(HandFault fault);
/// The cause of that name; none if there is none.
[[nodiscard]] std::optional<HandFault> findHandFault(std::string_view name);

}  // namespace tactooth
