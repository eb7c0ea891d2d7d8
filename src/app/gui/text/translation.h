// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string_view>

#include "geometry/util/message.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

struct Exercise;

/// The language of the window: that of the translator which is installed.
[[nodiscard]] Language windowLanguage();

/// A message in the language of the window.
[[nodiscard]] QString translated(const Message& message);

/// The name of a built-in tooth, exercise or spindle in the language of the window; any other text, as a file's name,
/// stays as it is.
[[nodiscard]] QString translated(std::string_view name);

/// The title of an exercise in the language of the window.
[[nodiscard]] QString exerciseTitle(const Exercise& exercise);

/// The text of a table that has both languages, in that of the window. UTF-8.
[[nodiscard]] QString inWindowLanguage(std::string_view english, std::string_view japanese);

/// The title of a material in the language of the window.
[[nodiscard]] QString materialTitle(const MaterialDefinition& material);
/// The same with a capital letter, to begin a label with.
[[nodiscard]] QString materialLabel(const MaterialDefinition& material);

}  // namespace tactooth
