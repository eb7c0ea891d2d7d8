// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/material_table.h"

#include <fmt/format.h>

#include "geometry/util/number_text.h"
#include "session/io/toml_text.h"

namespace tactooth {

std::string materialBlock(const MaterialDefinition& material, const std::string& table) {
    std::string text = fmt::format("\n[{}]\n", table);
    text += fmt::format("title_en = {}\ntitle_ja = {}\n", tomlText(material.titleEn), tomlText(material.titleJa));
    if (!builtinMaterials().find(material.name))
        text += fmt::format("role = \"{}\"\nnesting = {}\n", materialRoleName(material.role), material.nesting);
    for (const MaterialNumberKey& key : materialNumberKeys())
        text += fmt::format("{} = {}\n", key.name, numberText(key.of(material.numbers)));
    const auto& [red, green, blue] = material.numbers.colour;
    text +=
        fmt::format("{} = [{}, {}, {}]\n", kMaterialColourKey, numberText(red), numberText(green), numberText(blue));
    return text;
}

}  // namespace tactooth
