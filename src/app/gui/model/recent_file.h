// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <filesystem>
#include <vector>

namespace tactooth {

/// What the list of recent files holds: a file that was opened or saved, or the surfaces of a scan that was imported.
struct RecentFile {
    QStringList files;    ///< one, or all surfaces of the scan
    bool isScan = false;  ///< it is imported again, by way of the dialog

    /// One line, as the settings keep it: the file, or a word and the surfaces with tabs between them.
    [[nodiscard]] QString text() const;
    [[nodiscard]] static RecentFile fromText(const QString& text);

    bool operator==(const RecentFile&) const = default;
};

/// The files of all these lines but the surfaces of scans.
[[nodiscard]] std::vector<std::filesystem::path> openedFiles(const QStringList& texts);

}  // namespace tactooth
