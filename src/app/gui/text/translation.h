// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string_view>

#include "geometry/util/message.h"

namespace tactooth {

/// The language of the window: that of the translator which is installed.
[[nodiscard]] Language windowLanguage();

/// A message in the language of the window.
[[nodiscard]] QString translated(const Message& message);

/// The name of a built-in tooth, exercise or spindle, or the task of an exercise, in the language of the window; any
/// other text, as a file's name, stays as it is.
[[nodiscard]] QString translated(std::string_view name);

}  // namespace tactooth
