// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string_view>

#include "tooth/model/material_registry.h"

namespace tactooth {

/// A word that the layers below the window use (a tooth, a drive, a material, a state of the sound) in the language of
/// the window; the word itself if it has no translation, as a file's name.
[[nodiscard]] QString translated(std::string_view word);

/// The text of a table that has both languages, in that of the window. UTF-8.
[[nodiscard]] QString inWindowLanguage(std::string_view english, std::string_view japanese);

/// The title of a material in the language of the window.
[[nodiscard]] QString materialTitle(const MaterialDefinition& material);
/// The same with a capital letter, to begin a label with.
[[nodiscard]] QString materialLabel(const MaterialDefinition& material);

}  // namespace tactooth
