// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// How far the sides, the lingual fossa and the enamel of a built-in tooth are from measured ones (measured_faces.h).
#pragma once

#include <array>
#include <optional>

#include "instruments/builtin_tooth.h"

namespace tactooth::test {

/// Depths of the widest place of each side below the highest point of the crown, mm.
struct Contours {
    double mesial, distal, buccal, lingual;
};

/// `tooth` is one of the right side; buccal and lingual of front teeth: in the cervical third.
[[nodiscard]] Contours contoursOf(const BuiltinTooth& tooth);

/// mm, largest distance of a contour from the range of the measured ones; third molars have none.
[[nodiscard]] std::optional<double> contourDeviation(const BuiltinTooth& tooth);

/// mm, largest deviation of a depth of the lingual fossa; front teeth only.
[[nodiscard]] std::optional<double> fossaDeviation(const BuiltinTooth& tooth);

/// mm, largest deviation of the thickness of the enamel; only teeth of which it is measured.
[[nodiscard]] std::optional<double> enamelDeviation(const BuiltinTooth& tooth);

}  // namespace tactooth::test
