// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tactooth {

/// What a point of a tooth is made of: the index of a material in a MaterialRegistry. The type has no names: a material
/// is one block of data/materials.toml, or of a file of the user.
enum class MaterialId : std::uint8_t {};

/// The most materials that a registry holds: sums by material are arrays of this size, so that a step allocates
/// nothing.
inline constexpr std::size_t kMaxMaterials = 32;

/// What a material means to the program. Several materials may have the same role.
enum class MaterialRole : std::uint8_t {
    None,
    Enamel,        ///< the crown's shell; a tooth without layers is made of it
    Dentin,        ///< the body below the enamel
    Pulp,          ///< soft tissue that a cut must not reach
    Decay,         ///< what a cut is to remove
    Surroundings,  ///< gingiva, bone, and all else that a scan brings
};
/// The number of roles, None included.
inline constexpr std::size_t kMaterialRoleCount = 6;

/// Mechanics, removal, appearance and sound of a material.
struct Material {
    double stiffness;  ///< of the contact, N/mm
    double damping;    ///< of the contact, N*s/mm
    double friction;   ///< Coulomb coefficient against steel
    double removal;    ///< volume cut per force and rim travel, mm^3/(N*m): dV = removal * force * rim speed * dt
    std::array<float, 3> colour;  ///< sRGB, 0..1
    float roughness;              ///< of the picture, 0 mirror .. 1 matt
    double soundCentre;           ///< centre frequency of the cutting noise, Hz
    double soundBrightness;       ///< level of the cutting noise for the same removal power; sound enamel = 1
    float translucency = 0;       ///< of the picture, 0..1: how far light creeps around edges inside the material
    float wetness = 0;            ///< of the picture, 0..1: cover of saliva or water
    float grain = 0;              ///< of the picture, 0..1: fine unevenness of surface and colour
    float metalness = 0;          ///< of the picture, 0..1: reflects in its own colour, as metal
    double soundOctaves = 1;      ///< width of the cutting noise's band between its half-power points
    double soundGraininess = 0;   ///< 0 even hiss .. 1 separate crackling grains
    double tapFrequency = 0;      ///< lowest tone of the ring when an instrument knocks on the material, Hz
    double tapDecay = 0;          ///< time in which that ring falls to 1/e, s
    double tapBrightness = 0;     ///< 0 that tone alone .. 1 two higher tones as strong

    bool operator==(const Material&) const = default;
};

}  // namespace tactooth
