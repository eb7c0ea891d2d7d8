// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/drill_sound_state.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tactooth {

namespace {

// Band centres: hard and brittle 6-10 kHz, dentin and composite 3-6 kHz, softened tissue 1-3 kHz (healthy tissue sounds
// high, carious tissue low). Taps: the stiffer the contact, the shorter the impact and the higher its ring; decays of
// some milliseconds, since the periodontal ligament damps a tooth.
constexpr std::array<std::string_view, kSoundMaterials> kNames{"enamel",  "dentin",      "pulp",      "caries",
                                                               "amalgam", "restoration", "composite", "other"};
constexpr std::array<SoundCharacter, kSoundMaterials> kCharacters{{{7700.0, 0.75, 1.0, 0.4, 3900.0, 0.006, 0.8, 0},
                                                                   {4200.0, 1.0, 0.9, 0.3, 2100.0, 0.005, 0.35, 1},
                                                                   {700.0, 1.5, 0.25, 0.0, 180.0, 0.008, 0.0, 2},
                                                                   {1700.0, 1.5, 0.8, 0.1, 420.0, 0.007, 0.05, 3},
                                                                   {8200.0, 0.6, 1.0, 0.2, 4600.0, 0.012, 0.9, 4},
                                                                   {4900.0, 0.8, 0.85, 0.1, 2500.0, 0.004, 0.3, 5},
                                                                   {4900.0, 0.8, 0.85, 0.1, 2500.0, 0.004, 0.3, 6},
                                                                   {4200.0, 1.0, 0.9, 0.3, 2100.0, 0.005, 0.35, 7}}};

constexpr double kTopSpeedRpm = 1.0e6;    // twice the fastest turbine on sale
constexpr double kTopRemovalWatt = 1000;  // a turbine gives 30 W at most
constexpr double kTopContactSpeed = 1e4;  // mm/s: faster than any hand
constexpr double kTopContactForce = 100;  // N: more than any hand presses
constexpr int kMaxBlades = 60;            // finishing burs have 30

double within(double value, double low, double high, double otherwise) {
    return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
}

SoundCharacter sanitisedCharacter(const SoundCharacter& character) {
    const SoundCharacter usual;
    return {.bandCentreHz = within(character.bandCentreHz, 50.0, 16000.0, usual.bandCentreHz),
            .bandOctaves = within(character.bandOctaves, 0.1, 4.0, usual.bandOctaves),
            .level = within(character.level, 0.0, 1.0, 0.0),
            .graininess = within(character.graininess, 0.0, 1.0, 0.0),
            .tapHz = within(character.tapHz, 50.0, 16000.0, usual.tapHz),
            .tapDecay = within(character.tapDecay, 0.0005, 0.1, usual.tapDecay),
            .tapBrightness = within(character.tapBrightness, 0.0, 1.0, 0.0),
            .kind = std::min(character.kind, kSoundMaterials - 1)};
}

}  // namespace

std::span<const std::string_view, kSoundMaterials> soundMaterialNames() { return kNames; }

std::string soundMaterialList() {
    std::string list;
    for (const std::string_view name : kNames) list.append(list.empty() ? "" : ", ").append(name);
    return list;
}

std::optional<SoundCharacter> findSoundCharacter(std::string_view material) {
    const auto* found = std::find(kNames.begin(), kNames.end(), material);
    if (found == kNames.end()) return std::nullopt;
    return kCharacters[static_cast<std::size_t>(found - kNames.begin())];
}

SoundCharacter soundCharacterOf(std::string_view material) {
    return findSoundCharacter(material).value_or(*findSoundCharacter("dentin"));
}

DrillSoundState sanitised(const DrillSoundState& state) {
    DrillSoundState safe = state;
    safe.speedRpm = within(std::abs(state.speedRpm), 0.0, kTopSpeedRpm, 0.0);
    safe.freeSpeedRpm = within(state.freeSpeedRpm, 1.0, kTopSpeedRpm, kTopSpeedRpm);
    safe.pedal = within(state.pedal, 0.0, 1.0, 0.0);
    safe.load = within(state.load, 0.0, 1.0, 0.0);
    safe.removalPower = within(state.removalPower, 0.0, kTopRemovalWatt, 0.0);
    safe.blades = std::clamp(state.blades, 0, kMaxBlades);
    safe.contactSpeed = within(state.contactSpeed, 0.0, kTopContactSpeed, 0.0);
    safe.pullOutForce = within(state.pullOutForce, 0.0, kTopContactForce, 0.0);
    safe.contactForce = within(state.contactForce, 0.0, kTopContactForce, 0.0);
    safe.slideSpeed = within(state.slideSpeed, 0.0, kTopContactSpeed, 0.0);
    safe.water = within(state.water, 0.0, 1.0, 0.0);
    safe.suction = within(state.suction, 0.0, 1.0, 0.0);
    safe.material = sanitisedCharacter(state.material);
    return safe;
}

}  // namespace tactooth
