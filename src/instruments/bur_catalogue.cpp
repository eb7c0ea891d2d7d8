// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/bur_catalogue.h"

#include <algorithm>

namespace tactooth {

// Diameters and head lengths: the textbook table of US numbers and the ISO 6360 sizes of diamonds. Operative carbides
// have six blades, large round ones eight.
const std::vector<BurSpec>& burCatalogue() {
    using enum BurKind;
    using enum BurMaterial;
    static const std::vector<BurSpec> catalogue = {
        {"2", "Round carbide No. 2, 1.0 mm", round, carbide, 1.0, 0.80, 0, 6, 1.0},
        {"4", "Round carbide No. 4, 1.4 mm", round, carbide, 1.4, 1.10, 0, 6, 1.0},
        {"6", "Round carbide No. 6, 1.8 mm", round, carbide, 1.8, 1.45, 0, 8, 1.0},
        {"57", "Straight fissure carbide No. 57, 1.0 mm", straightFissure, carbide, 1.0, 4.2, 0, 6, 1.0},
        {"58", "Straight fissure carbide No. 58, 1.2 mm", straightFissure, carbide, 1.2, 4.2, 0, 6, 1.0},
        {"330", "Pear carbide No. 330, 0.8 mm", pear, carbide, 0.8, 1.6, -8, 6, 1.0},
        {"245", "Long pear carbide No. 245, 0.8 mm", pear, carbide, 0.8, 2.7, -4, 6, 1.0},
        {"801-014", "Round diamond 801-014, 1.4 mm", round, diamond, 1.4, 1.20, 0, 0, 1.0},
        {"856-016", "Round-end taper diamond 856-016, 1.6 mm", roundEndTaper, diamond, 1.6, 8.0, 5, 0, 1.0},
    };
    return catalogue;
}

std::optional<BurSpec> findBur(std::string_view number) {
    const std::vector<BurSpec>& catalogue = burCatalogue();
    const auto found = std::ranges::find(catalogue, number, &BurSpec::number);
    if (found == catalogue.end()) return std::nullopt;
    return *found;
}

}  // namespace tactooth
