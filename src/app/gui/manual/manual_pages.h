// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <map>
#include <vector>

#include "geometry/util/message.h"

namespace tactooth {

/// The pages of the manual in one language: the folder docs, as far as users need it, inside the program. A page is
/// known by its path in that folder: "user/replay.md".
class ManualPages {
public:
    /// `keyPage` gives the page of the keys as they are now.
    ManualPages(Language language, std::function<std::string()> keyPage);

    /// In the order of the contents list.
    [[nodiscard]] const QStringList& names() const { return names_; }
    [[nodiscard]] bool has(const QString& name) const { return names_.contains(name); }
    /// The page as Markdown. Without a page in this language: the English one, and a line that says so.
    [[nodiscard]] QString text(const QString& name) const;
    [[nodiscard]] QString title(const QString& name) const;
    /// The headings of its sections.
    [[nodiscard]] QStringList sections(const QString& name) const;

    /// A paragraph, a row or a heading that has all the words.
    struct Hit {
        QString page;
        int section;   ///< that it is in, from 1; 0: before the first
        QString text;  ///< around the first word
    };
    /// Looks for all words of `wanted` in any order, regardless of capital letters. The first `most` places.
    [[nodiscard]] std::vector<Hit> search(const QString& wanted, std::size_t most) const;

private:
    struct Block {
        int section;
        QString text;
    };
    [[nodiscard]] const std::vector<Block>& blocks(const QString& name) const;

    Language language_;
    std::function<std::string()> keyPage_;
    QStringList names_;
    mutable std::map<QString, std::vector<Block>> blocks_;  // made at the first search
};

/// The name by which a link leads to a heading, as on the pages of the repository: "6. An exercise" is
/// "6-an-exercise".
[[nodiscard]] QString anchorOf(const QString& heading);

}  // namespace tactooth
