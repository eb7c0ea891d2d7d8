// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace tactooth {

/// A language that the window can have.
struct LanguageName {
    QString title;  ///< each language by its own name
    QString code;   ///< as in the settings; empty: that of the system
};
[[nodiscard]] std::vector<LanguageName> languageNames();

}  // namespace tactooth
