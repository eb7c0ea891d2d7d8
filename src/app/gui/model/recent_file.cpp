// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/recent_file.h"

namespace tactooth {
namespace {

constexpr QLatin1String kScan("scan");  // no path: paths in the list are absolute
constexpr QChar kSeparator('\t');

}  // namespace

QString RecentFile::text() const { return isScan ? (QStringList(kScan) + files).join(kSeparator) : files.value(0); }

RecentFile RecentFile::fromText(const QString& text) {
    const QStringList parts = text.split(kSeparator);
    if (parts.size() < 2 || parts.front() != kScan) return {{text}, false};
    return {parts.mid(1), true};
}

std::vector<std::filesystem::path> openedFiles(const QStringList& texts) {
    std::vector<std::filesystem::path> opened;
    for (const QString& text : texts) {
        const RecentFile recent = RecentFile::fromText(text);
        if (!recent.isScan) opened.emplace_back(recent.files.front().toStdString());
    }
    return opened;
}

}  // namespace tactooth
