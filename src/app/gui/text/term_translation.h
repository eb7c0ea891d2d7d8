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

/// The title of a material in the language of the window.
[[nodiscard]] QString materialTitle(const MaterialDefinition& material);
/// The same with a capital letter, to begin a label with.
[[nodiscard]] QString materialLabel(const MaterialDefinition& material);

}  // namespace tactooth
