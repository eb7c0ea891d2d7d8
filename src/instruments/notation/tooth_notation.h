// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/util/message.h"

namespace tactooth {

/// How people number the permanent teeth. Everywhere else in the program a tooth has its FDI number.
enum class ToothNotation {
    Fdi,        ///< ISO 3950: quadrant and place, "46"
    Universal,  ///< 1 to 32, from the upper right third molar around to the lower right one, "30"
    Palmer,     ///< place and a corner that stands for the quadrant, as one sees it on the patient, "6┐"
};

/// The number of a permanent tooth (isPermanentTooth) in a notation. UTF-8.
[[nodiscard]] std::string toothLabel(int fdi, ToothNotation notation);

/// The FDI number of the tooth that `text` names in a notation; none if it names no permanent tooth. Palmer takes the
/// corner (┘ └ ┌ ┐), or the letters UR, UL, LL, LR before the place.
[[nodiscard]] std::optional<int> toothNamed(std::string_view text, ToothNotation notation);

/// The name of a permanent tooth in any language: "Upper right first molar", as toothName.
[[nodiscard]] Message toothTitle(int fdi);

}  // namespace tactooth
