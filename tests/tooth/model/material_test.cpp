// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/model/material_registry.h"

#include <gtest/gtest.h>

#include <set>

#include "support/materials.h"

namespace tactooth {
namespace {

MaterialDefinition definitionOf(const std::string& name, std::uint8_t code) {
    MaterialDefinition one;
    one.name = name;
    one.code = code;
    return one;
}

/// The built-in materials and some more.
const MaterialRegistry& withMore(const std::vector<MaterialDefinition>& more) {
    std::vector<MaterialDefinition> all = builtinMaterials().definitions();
    all.insert(all.end(), more.begin(), more.end());
    return MaterialRegistry::make(std::move(all));
}

std::vector<std::string> namesOf(const MaterialRegistry& registry, std::span<const MaterialId> ids) {
    std::vector<std::string> names;
    for (const MaterialId id : ids) names.push_back(registry.nameOf(id));
    return names;
}

TEST(MaterialRegistry, EveryNameAndCodeLeadsBackToItsMaterial) {
    const MaterialRegistry& all = builtinMaterials();
    for (const MaterialId id : all.ids()) {
        EXPECT_EQ(all.find(all.nameOf(id)), id);
        EXPECT_EQ(all.findCode(all[id].code), id);
    }
    EXPECT_EQ(all.find("Enamel"), std::nullopt);
    EXPECT_EQ(all.findCode(99), std::nullopt);
}

/// Files of saved teeth, and tags of surfaces in caches, hold these numbers.
TEST(MaterialRegistry, TheBuiltInMaterialsKeepTheirIndicesAndHaveUniqueCodes) {
    const MaterialRegistry& all = builtinMaterials();
    EXPECT_EQ(all.find("enamel"), test::kEnamel);
    EXPECT_EQ(all.find("dentin"), test::kDentin);
    EXPECT_EQ(all.find("pulp"), test::kPulp);
    EXPECT_EQ(all.find("other"), test::kOther);
    EXPECT_EQ(all.find("restoration"), test::kRestoration);
    EXPECT_EQ(all.find("caries"), test::kCaries);
    std::set<std::uint8_t> codes;
    for (const MaterialId id : all.ids()) EXPECT_TRUE(codes.insert(all[id].code).second) << all.nameOf(id);
}

TEST(MaterialRegistry, ListsForMenusAndByRole) {
    const MaterialRegistry& all = builtinMaterials();
    const std::vector<std::string> menu = {"enamel", "dentin", "pulp", "caries", "restoration", "other"};
    const std::vector<std::string> roles = {"enamel", "dentin", "pulp", "caries", "other", "restoration"};
    // A further material comes in between.
    const auto amongThese = [&menu](std::vector<std::string> names) {
        std::erase_if(names, [&](const std::string& name) { return std::ranges::find(menu, name) == menu.end(); });
        return names;
    };
    EXPECT_EQ(amongThese(namesOf(all, all.inMenuOrder())), menu);
    EXPECT_EQ(amongThese(namesOf(all, all.byRole())), roles);
    for (const std::string& name : menu) EXPECT_NE(all.names().find(name), std::string::npos) << name;
}

TEST(MaterialRegistry, ARoleIsThatOfTheFirstMaterialWithIt) {
    MaterialDefinition second = definitionOf("pulp-stone", 80);
    second.role = MaterialRole::Pulp;
    const MaterialRegistry& all = withMore({second});
    EXPECT_EQ(all.withRole(MaterialRole::Pulp), test::kPulp);
    EXPECT_TRUE(all.hasRole(all.find("pulp-stone").value(), MaterialRole::Pulp));
    EXPECT_EQ(builtinMaterials().withRole(MaterialRole::Decay), test::kCaries);
    EXPECT_EQ(builtinMaterials().withRole(MaterialRole::Surroundings), test::kOther);
}

TEST(MaterialRegistry, TheCodeGivesTheIndexAndTheOrderOfGivingThatOfTheMenus) {
    const MaterialRegistry& all = withMore({definitionOf("b", 70), definitionOf("a", 65)});
    const std::size_t builtin = builtinMaterials().size();
    EXPECT_EQ(all.nameOf(static_cast<MaterialId>(builtin)), "a");
    EXPECT_EQ(all.nameOf(static_cast<MaterialId>(builtin + 1)), "b");
    EXPECT_EQ(all.names(), builtinMaterials().names() + ", b, a");
    EXPECT_EQ(all.find("enamel"), test::kEnamel);
}

TEST(MaterialRegistry, EqualListsAreOneRegistry) {
    EXPECT_EQ(&withMore({}), &builtinMaterials());
    EXPECT_EQ(&withMore({definitionOf("gold", 64)}), &withMore({definitionOf("gold", 64)}));
    EXPECT_NE(&withMore({definitionOf("gold", 64)}), &withMore({definitionOf("gold", 65)}));
}

TEST(MaterialRegistry, AFreeCodeIsOneThatNobodyHas) {
    const std::vector<MaterialDefinition> taken = {definitionOf("a", 64), definitionOf("b", 65)};
    EXPECT_EQ(MaterialRegistry::freeCode(taken), 66);
    EXPECT_EQ(MaterialRegistry::freeCode({}), 64);
}

TEST(MaterialDefinition, ANameCanNameAFile) {
    for (const char* good : {"a", "composite", "resin-2", "gold_alloy"}) EXPECT_TRUE(isMaterialName(good)) << good;
    for (const char* bad : {"", "Gold", "2nd", "a/b", "a b", "..", "-a", "\xE6\xAD\xAF"})
        EXPECT_FALSE(isMaterialName(bad));
    EXPECT_TRUE(isMaterialName(std::string(40, 'a')));
    EXPECT_FALSE(isMaterialName(std::string(41, 'a')));
}

TEST(MaterialTable, HasTheNumbersOfItsRegistry) {
    const MaterialTable table;
    for (const MaterialId id : table.registry().ids()) EXPECT_EQ(table[id], builtinMaterials()[id].numbers);
    MaterialDefinition gold = definitionOf("gold", 64);
    gold.numbers.stiffness = 0.7;
    const MaterialTable more(withMore({gold}));
    EXPECT_EQ(more[more.registry().find("gold").value()].stiffness, 0.7);
}

TEST(MaterialTable, DecayCutsFasterThanDentinAndDentinFasterThanEnamel) {
    const MaterialTable table;
    const double enamel = table[test::kEnamel].removal;
    EXPECT_GE(table[test::kDentin].removal, 2 * enamel);
    EXPECT_LE(table[test::kDentin].removal, 4 * enamel);
    EXPECT_GE(table[test::kCaries].removal, 8 * enamel);
}

TEST(MaterialTable, TheHarderTheTissueTheHigherItSounds) {
    const MaterialTable table;
    const MaterialId order[] = {test::kEnamel, test::kRestoration, test::kDentin, test::kCaries, test::kPulp};
    for (int i = 0; i + 1 < 5; ++i) EXPECT_GT(table[order[i]].soundCentre, table[order[i + 1]].soundCentre);
    EXPECT_EQ(table[test::kEnamel].soundBrightness, 1);
    for (const MaterialId id : table.registry().ids()) EXPECT_LE(table[id].soundBrightness, 1);
}

TEST(MaterialTable, OneNewtonOnEnamelAtFullSpeedStaysWithinTheMeasuredRates) {
    const double rate = MaterialTable{}[test::kEnamel].removal * 1.0 * 15.7;  // N, m/s -> mm^3/s
    EXPECT_GE(rate, 0.06);
    EXPECT_LE(rate, 0.3);
}

}  // namespace
}  // namespace tactooth
