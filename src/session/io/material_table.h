// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "session/io/toml_reader.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

/// Materials that stand in a table of another file, in the syntax of a file of materials (readMaterials), on top of
/// `start`. Reports a mistake to `toml`, and then returns `start`.
[[nodiscard]] const MaterialRegistry& materialsIn(TomlReader& toml, const toml::table& blocks,
                                                  const MaterialRegistry& start = builtinMaterials());

/// The block of a material in that syntax, with all its keys but the code. `table`: its name there, as
/// "materials.amalgam".
[[nodiscard]] std::string materialBlock(const MaterialDefinition& material, const std::string& table);

}  // namespace tactooth
