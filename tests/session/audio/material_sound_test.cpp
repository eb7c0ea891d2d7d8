// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/audio/material_sound.h"

#include <gtest/gtest.h>

#include <set>

#include "session/io/material_file.h"
#include "support/materials.h"

namespace tactooth {
namespace {

MaterialTable tableOf(std::string_view text) {
    const auto registry = parseMaterials(text, "mine.toml");
    EXPECT_TRUE(registry) << registry.error().message();
    return MaterialTable(registry ? **registry : builtinMaterials());
}

SoundCharacter soundNamed(const MaterialTable& materials, std::string_view name) {
    return characterOf(materials, materials.registry().find(name).value());
}

TEST(MaterialSound, HasTheNumbersOfTheTable) {
    const MaterialTable materials = tableOf(
        "[gold]\nsound_centre = 3100\nsound_level = 0.7\nsound_octaves = 0.6\nsound_graininess = 0.15\n"
        "tap_frequency = 1300\ntap_decay = 0.009\ntap_brightness = 0.45\n");
    const SoundCharacter gold = soundNamed(materials, "gold");
    EXPECT_EQ(gold.bandCentreHz, 3100);
    EXPECT_EQ(gold.level, 0.7);
    EXPECT_EQ(gold.bandOctaves, 0.6);
    EXPECT_EQ(gold.graininess, 0.15);
    EXPECT_EQ(gold.tapHz, 1300);
    EXPECT_EQ(gold.tapDecay, 0.009);
    EXPECT_EQ(gold.tapBrightness, 0.45);
}

TEST(MaterialSound, IsOfOneKindWhateverElseTheToothIsMadeOf) {
    const MaterialTable few = tableOf("[gold]\n"), many = tableOf("[alloy]\n[cement]\n[gold]\n");
    EXPECT_NE(few.registry().find("gold"), many.registry().find("gold")) << "other ids";
    EXPECT_EQ(soundNamed(few, "gold").kind, soundNamed(many, "gold").kind);
    std::set<std::size_t> kinds;
    for (const MaterialId id : many.registry().ids()) kinds.insert(characterOf(many, id).kind);
    EXPECT_EQ(kinds.size(), many.registry().size());
}

TEST(MaterialSound, TheRecordingOfOtherStandsInForThatOfAMaterialThatTheProgramDoesNotKnow) {
    const MaterialTable materials = tableOf("[gold]\n[amalgam]\n[composite]\n");
    EXPECT_EQ(soundNamed(materials, "gold").standIn, soundKindOf("other"));
    for (const MaterialId id : dentalMaterials().ids()) {
        const std::string& name = dentalMaterials().nameOf(id);
        EXPECT_EQ(soundNamed(materials, name).standIn, soundKindOf(name)) << name;
    }
}

TEST(MaterialSound, CompositeSoundsAsARestoration) {
    const MaterialTable materials(dentalMaterials());
    const SoundCharacter composite = soundNamed(materials, "composite");
    const SoundCharacter restoration = characterOf(materials, test::kRestoration);
    EXPECT_EQ(composite.bandCentreHz, restoration.bandCentreHz);
    EXPECT_EQ(composite.bandOctaves, restoration.bandOctaves);
    EXPECT_EQ(composite.level, restoration.level);
    EXPECT_EQ(composite.graininess, restoration.graininess);
    EXPECT_EQ(composite.tapHz, restoration.tapHz);
    EXPECT_EQ(composite.tapDecay, restoration.tapDecay);
    EXPECT_EQ(composite.tapBrightness, restoration.tapBrightness);
    EXPECT_NE(composite.kind, restoration.kind) << "each may have a recording";
}

}  // namespace
}  // namespace tactooth
