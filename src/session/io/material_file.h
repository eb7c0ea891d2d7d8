// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

#include "geometry/util/expected.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

/// The text of data/materials.toml, which is built into the program. It explains itself, so it also serves as the
/// pattern for a file of one's own.
[[nodiscard]] std::string_view defaultMaterialsText();

/// The text of data/dental_materials.toml, which is built into the program as well.
[[nodiscard]] std::string_view dentalMaterialsText();

/// The built-in materials and those of data/dental_materials.toml.
[[nodiscard]] const MaterialRegistry& dentalMaterials();

/// `materials`, and behind them those of dentalMaterials() whose names they lack, as far as there is room.
[[nodiscard]] const MaterialRegistry& withDentalMaterials(const MaterialRegistry& materials);

/// Reads a TOML file of materials. What the file does not name stays as in `builtinMaterials`. A block with a new name
/// adds a material: what the block leaves out is as in the block [other].
///
/// Fails with one sentence with file and line: not TOML, a name that no material may have, a key that does not exist, a
/// value of another kind than expected, a number that is negative, not finite or above what a device may render, a code
/// that another material has, role, nesting or code of a built-in material, more than kMaxMaterials materials.
[[nodiscard]] Expected<const MaterialRegistry*> readMaterials(const std::filesystem::path& path);

/// The materials of that file, or the built-in ones for an empty path.
[[nodiscard]] Expected<const MaterialRegistry*> materialsFrom(const std::filesystem::path& fileOrNothing);

/// The same from memory, on top of `start`; `name` stands for the file in messages.
[[nodiscard]] Expected<const MaterialRegistry*> parseMaterials(std::string_view text, std::string_view name,
                                                               const MaterialRegistry& start = builtinMaterials());

}  // namespace tactooth
