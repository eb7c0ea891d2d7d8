// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "tooth/model/material.h"

namespace tactooth {

/// One block of a materials file.
struct MaterialDefinition {
    std::string name = {};                   ///< in files and on the command line: see isMaterialName
    std::string titleEn = {}, titleJa = {};  ///< in the window
    MaterialRole role = MaterialRole::None;
    int nesting = 0;        ///< where layers overlap, the higher one is there; the later one of equals
    std::uint8_t code = 0;  ///< in the files of saved teeth; unique in a registry
    Material numbers = {};

    bool operator==(const MaterialDefinition&) const = default;
};

/// A key of such a block that holds a number.
struct MaterialNumberKey {
    std::string_view name;
    double highest;  ///< the lowest is 0
    std::variant<double Material::*, float Material::*> member;

    [[nodiscard]] double of(const Material& material) const;
    void set(Material& material, double value) const;
};
[[nodiscard]] std::span<const MaterialNumberKey> materialNumberKeys();

/// The key that holds three numbers: the colour.
inline constexpr std::string_view kMaterialColourKey = "colour";

inline constexpr int kMaxMaterialNesting = 1000;
inline constexpr int kMaxMaterialCode = 255;

/// "enamel", "dentin", "pulp", "decay", "surroundings" or "none".
[[nodiscard]] std::optional<MaterialRole> materialRoleNamed(std::string_view name);
[[nodiscard]] std::string_view materialRoleName(MaterialRole role);
/// These names, with commas between them.
[[nodiscard]] std::string materialRoleNames();

/// Whether a material may have this name: 1 to 40 small letters, digits, '-' and '_', the first a letter. Files are
/// named after materials.
[[nodiscard]] bool isMaterialName(std::string_view name);

/// Limits of a material from a file, more than twice what any device renders. A file, above all one that came with a
/// case, may come from anybody, and a hand feels what it says.
inline constexpr double kMaxMaterialStiffness = 5;   ///< N/mm
inline constexpr double kMaxMaterialDamping = 0.02;  ///< N*s/mm
inline constexpr double kMaxMaterialFriction = 2;    ///< Coulomb coefficient

}  // namespace tactooth
