// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/model/material_definition.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tactooth {
namespace {

constexpr double kMaxRemoval = 10;         // mm^3/(N*m): butter; pulp has 0.3
constexpr double kHighestFrequency = 2e4;  // Hz: what an ear hears
constexpr double kMaxOctaves = 4;
constexpr double kMaxTapDecay = 0.1;  // s: a bell

constexpr std::array<MaterialNumberKey, 16> kNumberKeys = {{
    {"stiffness", kMaxMaterialStiffness, &Material::stiffness},
    {"damping", kMaxMaterialDamping, &Material::damping},
    {"friction", kMaxMaterialFriction, &Material::friction},
    {"removal", kMaxRemoval, &Material::removal},
    {"roughness", 1, &Material::roughness},
    {"translucency", 1, &Material::translucency},
    {"wetness", 1, &Material::wetness},
    {"grain", 1, &Material::grain},
    {"metalness", 1, &Material::metalness},
    {"sound_centre", kHighestFrequency, &Material::soundCentre},
    {"sound_level", 1, &Material::soundBrightness},
    {"sound_octaves", kMaxOctaves, &Material::soundOctaves},
    {"sound_graininess", 1, &Material::soundGraininess},
    {"tap_frequency", kHighestFrequency, &Material::tapFrequency},
    {"tap_decay", kMaxTapDecay, &Material::tapDecay},
    {"tap_brightness", 1, &Material::tapBrightness},
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

double MaterialNumberKey::of(const Material& material) const {
    return std::visit([&](auto number) { return static_cast<double>(material.*number); }, member);
}

void MaterialNumberKey::set(Material& material, double value) const {
    std::visit([&]<class Number>(Number Material::*number) { material.*number = static_cast<Number>(value); }, member);
}

std::span<const MaterialNumberKey> materialNumberKeys() { return kNumberKeys; }

std::optional<MaterialRole> materialRoleNamed(std::string_view name) {
    for (const auto& [known, role] : kRoles) {
        if (known == name) return role;
    }
    return std::nullopt;
}

std::string_view materialRoleName(MaterialRole role) {
    return std::ranges::find(kRoles, role, &std::pair<std::string_view, MaterialRole>::second)->first;
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
