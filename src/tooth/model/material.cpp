// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/model/material.h"

#include <algorithm>

namespace tactooth {
namespace {

constexpr std::array<std::string_view, kMaterialCount> kNames = {"enamel", "dentin",      "pulp",
                                                                 "other",  "restoration", "caries"};

// Stiffness: the stiffest wall that an affordable device renders cleanly is about 0.8-1 N/mm (update rate against clean
// stiffness: 0.3 N/mm at 250 Hz to 0.9 N/mm at 40 kHz), so enamel takes 1 and the others stand below it in the order
// of their hardness (Knoop 350-430 enamel, 68 dentin, 20-50 decayed dentin, 55-60 composite), spread by at least one
// just noticeable difference (23 %). Damping: 1-3 N*s/m is what a hand does not feel as viscous.
// Removal: F_n * v_rim law, enamel 0.004-0.02 mm^3/(N*m) so that 1 N at 15 m/s takes 0.06-0.3 mm^3/s; dentin 2-4 times,
// decayed dentin 8-15 times, composite 1.5-3 times that of enamel; pulp is no obstacle at all.
// Sound: band centres 6-10 kHz for hard and brittle tissue, 3-6 kHz for dentin and composite, 1-3 kHz for softened
// tissue (healthy tissue sounds treble, carious tissue bass); the levels are chosen by ear.
constexpr Material kEnamel = {1.00, 0.0020, 0.10, 0.010, {0.93F, 0.90F, 0.84F}, 0.25F, 7700.0, 1.00};
constexpr Material kDentin = {0.65, 0.0020, 0.15, 0.030, {0.89F, 0.77F, 0.54F}, 0.60F, 4200.0, 0.90};
constexpr Material kPulp = {0.10, 0.0010, 0.25, 0.300, {0.72F, 0.20F, 0.20F}, 0.45F, 700.0, 0.25};
constexpr Material kOther = {0.50, 0.0020, 0.15, 0.030, {0.75F, 0.73F, 0.70F}, 0.60F, 4200.0, 0.90};
constexpr Material kRestoration = {0.80, 0.0020, 0.12, 0.020, {0.86F, 0.84F, 0.78F}, 0.40F, 4900.0, 0.85};
constexpr Material kCaries = {0.25, 0.0015, 0.25, 0.110, {0.45F, 0.30F, 0.15F}, 0.80F, 1700.0, 0.80};

}  // namespace

std::string_view materialName(MaterialId id) { return kNames[static_cast<std::size_t>(id)]; }

std::optional<MaterialId> materialFromName(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<MaterialId>(found - kNames.begin());
}

MaterialTable::MaterialTable() : materials_{kEnamel, kDentin, kPulp, kOther, kRestoration, kCaries} {}

}  // namespace tactooth
