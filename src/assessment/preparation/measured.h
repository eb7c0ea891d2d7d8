// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/util/message.h"
#include "geometry/util/vec.h"

namespace tactooth {

/// How an error was made.
struct RemovalCause {
    double from, to;                  ///< while the hand removed most of it, s since the session began
    double force;                     ///< mean while the tool touched, N
    std::optional<double> tilt = {};  ///< of the shaft against the axis of the preparation, mean, degrees
};

/// One measured value, or the reason why there is none. What cannot be measured is never 0.
struct Measured {
    std::optional<double> value = {};
    const MessageText* reason = nullptr;     ///< why there is no value; null where there is one
    std::optional<Vec3> place = {};          ///< where it was measured, mm; none for a value of the whole preparation
    std::optional<double> moment = {};       ///< when the material there was removed, s since the session began
    std::optional<RemovalCause> cause = {};  ///< of an error that was made in that session

    [[nodiscard]] static Measured at(double value, const Vec3& place) { return {.value = value, .place = place}; }
    [[nodiscard]] static Measured of(double value) { return {.value = value}; }
    [[nodiscard]] static Measured none(const MessageText& reason) { return {.reason = &reason}; }
};

}  // namespace tactooth
