// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <span>
#include <vector>

namespace tactooth {

/// What the user can go on with.
struct RecentWork {
    enum class Kind { Tooth, Scan, Case, Exercise, Recording };
    QString file;   ///< as RecentFile::text
    QString title;  ///< for people
    Kind kind;
    QDateTime time;  ///< of its last change

    bool operator==(const RecentWork&) const = default;
};

/// The files that were opened or saved last, as RecentFile::text, and the recordings that ended last, at most `most` of
/// each, the newest first. A file that has gone is left out, and one that is in both lists comes once.
[[nodiscard]] std::vector<RecentWork> recentWork(const QStringList& files,
                                                 std::span<const std::filesystem::path> recordings, int most);

}  // namespace tactooth
