// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/model/material.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(Material, EveryNameLeadsBackToItsMaterial) {
    for (std::size_t i = 0; i < kMaterialCount; ++i) {
        const auto id = static_cast<MaterialId>(i);
        EXPECT_EQ(materialFromName(materialName(id)), id);
    }
    EXPECT_EQ(materialFromName("Enamel"), std::nullopt);
}

TEST(Material, DecayCutsFasterThanDentinAndDentinFasterThanEnamel) {
    const MaterialTable table;
    const double enamel = table[MaterialId::Enamel].removal;
    EXPECT_GE(table[MaterialId::Dentin].removal, 2 * enamel);
    EXPECT_LE(table[MaterialId::Dentin].removal, 4 * enamel);
    EXPECT_GE(table[MaterialId::Caries].removal, 8 * enamel);
}

TEST(Material, TheHarderTheTissueTheHigherItSounds) {
    const MaterialTable table;
    const MaterialId order[] = {MaterialId::Enamel, MaterialId::Restoration, MaterialId::Dentin, MaterialId::Caries,
                                MaterialId::Pulp};
    for (int i = 0; i + 1 < 5; ++i) EXPECT_GT(table[order[i]].soundCentre, table[order[i + 1]].soundCentre);
    EXPECT_EQ(table[MaterialId::Enamel].soundBrightness, 1);
    for (std::size_t i = 0; i < kMaterialCount; ++i) EXPECT_LE(table[static_cast<MaterialId>(i)].soundBrightness, 1);
}

TEST(Material, OneNewtonOnEnamelAtFullSpeedStaysWithinTheMeasuredRates) {
    const double rate = MaterialTable{}[MaterialId::Enamel].removal * 1.0 * 15.7;  // N, m/s -> mm^3/s
    EXPECT_GE(rate, 0.06);
    EXPECT_LE(rate, 0.3);
}

}  // namespace
}  // namespace tactooth
