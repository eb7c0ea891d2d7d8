// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/model/material_definition.h"

#include <algorithm>
#include <array>

namespace tactooth {
namespace {

constexpr double kMaxRemoval = 10;         // mm^3/(N*m): butter; pulp has 0.3
constexpr double kHighestFrequency = 2e4;  // Hz: what an ear hears
constexpr double kMaxOctaves = 4;
constexpr double kMaxTapDecay = 0.1;  // s: a bell

constexpr std::array<MaterialNumberKey, 15> kNumberKeys = {{
    {"stiffness", kMaxMaterialStiffness, [](Material& m, double value) { m.stiffness = value; }},
    {"damping", kMaxMaterialDamping, [](Material& m, double value) { m.damping = value; }},
    {"friction", kMaxMaterialFriction, [](Material& m, double value) { m.friction = value; }},
    {"removal", kMaxRemoval, [](Material& m, double value) { m.removal = value; }},
    {"roughness", 1, [](Material& m, double value) { m.roughness = static_cast<float>(value); }},
    {"translucency", 1, [](Material& m, double value) { m.translucency = static_cast<float>(value); }},
    {"wetness", 1, [](Material& m, double value) { m.wetness = static_cast<float>(value); }},
    {"grain", 1, [](Material& m, double value) { m.grain = static_cast<float>(value); }},
    {"sound_centre", kHighestFrequency, [](Material& m, double value) { m.soundCentre = value; }},
    {"sound_level", 1, [](Material& m, double value) { m.soundBrightness = value; }},
    {"sound_octaves", kMaxOctaves, [](Material& m, double value) { m.soundOctaves = value; }},
    {"sound_graininess", 1, [](Material& m, double value) { m.soundGraininess = value; }},
    {"tap_frequency", kHighestFrequency, [](Material& m, double value) { m.tapFrequency = value; }},
    {"tap_decay", kMaxTapDecay, [](Material& m, double value) { m.tapDecay = value; }},
    {"tap_brightness", 1, [](Material& m, double value) { m.tapBrightness = value; }},
}};

constexpr std::array<std::pair<std::string_view, MaterialRole>, kMaterialRoleCount> kRoles = {{
    {"enamel", MaterialRole::Enamel},
    {"dentin", MaterialRole::Dentin},
    {"pulp", MaterialRole::Pulp},
    {"decay", MaterialRole::Decay},
    {"surroundings", MaterialRole::Surroundings},
    {"none", MaterialRole::None},
}};

}  // namespace

std::span<const MaterialNumberKey> materialNumberKeys() { return kNumberKeys; }

std::optional<MaterialRole> materialRoleNamed(std::string_view name) {
    for (const auto& [known, role] : kRoles) {
        if (known == name) return role;
    }
    return std::nullopt;
}

std::string materialRoleNames() {
    std::string names;
    for (const auto& [name, role] : kRoles) names.append(names.empty() ? "" : ", ").append(name);
    return names;
}

bool isMaterialName(std::string_view name) {
    constexpr std::size_t kLongest = 40;
    const auto isSmall = [](char c) { return c >= 'a' && c <= 'z'; };
    if (name.empty() || name.size() > kLongest || !isSmall(name.front())) return false;
    return std::ranges::all_of(name,
                               [&](char c) { return isSmall(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; });
}

}  // namespace tactooth
