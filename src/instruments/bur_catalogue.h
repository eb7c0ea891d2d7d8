// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tactooth {

/// The shape of a bur's head.
enum class BurKind {
    round,            ///< a ball
    straightFissure,  ///< a cylinder with a flat end
    pear,             ///< a rounded end, narrowing toward the shank
    roundEndTaper     ///< a rounded end, widening toward the shank
};

enum class BurMaterial { carbide, diamond };

/// One line of the catalogue: what a dentist orders. Lengths in mm.
struct BurSpec {
    std::string number;  ///< US number ("4"), or the ISO shape and size of a diamond ("856-016")
    std::string name;    ///< for people
    BurKind kind = BurKind::round;
    BurMaterial material = BurMaterial::carbide;
    double headDiameter = 1;  ///< the largest diameter of the head
    double headLength = 1;    ///< from the tip to the end of the blades
    double taperDegrees = 0;  ///< full cone angle, positive where the head widens toward the shank
    int flutes = 6;           ///< number of blades; 0 for a diamond
    double sharpness = 1;     ///< cutting ability: 1 as new, 0 does not cut
};

/// Every bur that the program makes by itself, in the order in which a list shows them.
[[nodiscard]] const std::vector<BurSpec>& burCatalogue();

/// The bur with this number, if the catalogue has it.
[[nodiscard]] std::optional<BurSpec> findBur(std::string_view number);

}  // namespace tactooth
