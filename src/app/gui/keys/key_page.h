// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "app/gui/keys/key_map.h"

namespace tactooth {

/// How a key is written.
using KeyWriter = std::function<QString(const QKeySequence&)>;

/// The page of mouse and keys in Markdown. `note`: what stands below the title, in the same language.
[[nodiscard]] std::string keyPage(const KeyMap& map, Language language, const std::string& note,
                                  const KeyWriter& write);

/// The file docs/user/keys.md or keys.ja.md: the usual keys.
[[nodiscard]] std::string keyPageFile(Language language);
/// The page with the keys as they are now, as the desktop writes them.
[[nodiscard]] std::string ownKeyPage(const KeyMap& map, Language language);

}  // namespace tactooth
