// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

#include "geometry/util/expected.h"
#include "tooth/model/material.h"

namespace tactooth {

/// The most that a file may ask of a material, above twice of what any device renders: a file, above all one that came
/// with a case, may be anybody's, and what it says is felt by a hand.
inline constexpr double kMaxMaterialStiffness = 5;   ///< N/mm
inline constexpr double kMaxMaterialDamping = 0.02;  ///< N*s/mm
inline constexpr double kMaxMaterialFriction = 2;    ///< Coulomb coefficient

/// The text of data/materials.toml, which is built into the program. It explains itself, so it also serves as the
/// pattern for a file of one's own.
[[nodiscard]] std::string_view defaultMaterialsText();

/// The materials of that text.
[[nodiscard]] MaterialTable defaultMaterials();

/// Reads a TOML file of materials. What the file does not name stays as in `defaultMaterials`.
///
/// Fails with one sentence with file and line: not TOML, a material or a key that does not exist, a value of another
/// kind than expected, a number that is negative, not finite or above what a device may render.
[[nodiscard]] Expected<MaterialTable> readMaterials(const std::filesystem::path& path);

/// The materials of that file, or of the built-in table for an empty path.
[[nodiscard]] Expected<MaterialTable> materialsFrom(const std::filesystem::path& fileOrNothing);

/// The same from memory, on top of `start`; `name` stands for the file in messages.
[[nodiscard]] Expected<MaterialTable> parseMaterials(std::string_view text, std::string_view name,
                                                     const MaterialTable& start);

}  // namespace tactooth
