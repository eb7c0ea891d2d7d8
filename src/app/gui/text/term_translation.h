// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string_view>

namespace tactooth {

/// A word that the layers below the window use (a tooth, a drive, a material, a state of the sound) in the language of
/// the window; the word itself if it has no translation, as a file's name.
[[nodiscard]] QString translated(std::string_view word);

}  // namespace tactooth
