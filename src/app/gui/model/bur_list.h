// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "instruments/bur_catalogue.h"

namespace tactooth {

/// A bur that the user can choose.
struct BurItem {
    int place = 0;                ///< in the list of the drill bar
    QString title;                ///< in the language of the window
    std::optional<BurSpec> spec;  ///< of the catalogue; none: it is from a file
    bool isAllowed = true;        ///< by the exercise
};

/// The burs of one shape, in the order of the catalogue.
struct BurGroup {
    QString title;
    std::vector<BurItem> burs;
};

/// Groups by shape; those from files come last.
[[nodiscard]] std::vector<BurGroup> groupedByShape(const std::vector<BurItem>& burs);

/// "ISO 500 314 001 001 014", diameter and length of the head: a line for each. Empty for a bur from a file.
[[nodiscard]] QStringList factsOf(const BurItem& bur);

/// Whether each word of `search` is in the title, the number, the ISO number with or without its spaces, or one of the
/// sizes of the bur. Capitals do not matter.
[[nodiscard]] bool matches(const BurItem& bur, const QString& search);

/// Numbers of burs, as the settings keep them: "4, 245". Unknown ones are left out.
[[nodiscard]] std::set<std::string> burNumbers(const std::string& text);
[[nodiscard]] std::string asText(const std::set<std::string>& burNumbers);

}  // namespace tactooth
