// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/recent_work.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <algorithm>

#include "app/gui/model/recent_file.h"
#include "app/gui/text/translation.h"
#include "session/cases/case_store.h"
#include "session/recording/session_recording.h"

namespace tactooth {
namespace {

RecentWork::Kind kindOf(const RecentFile& recent) {
    if (recent.isScan) return RecentWork::Kind::Scan;
    const std::filesystem::path path = recent.files.front().toStdString();
    if (path.extension() == kSessionFileEnding) return RecentWork::Kind::Recording;
    if (isCase(path)) return RecentWork::Kind::Case;
    return path.extension() == ".toml" ? RecentWork::Kind::Exercise : RecentWork::Kind::Tooth;
}

/// The name of a recording begins with its date (recordingName), which the card shows below.
QString titleOf(const QFileInfo& file) {
    static const QRegularExpression date(R"(^\d{4}-\d\d-\d\d \d\d\.\d\d )");
    QString name = file.completeBaseName();
    return translated(name.remove(date).toStdString());
}

}  // namespace

std::vector<RecentWork> recentWork(const QStringList& files, std::span<const std::filesystem::path> recordings,
                                   int most) {
    QStringList all = files.mid(0, most);
    for (const auto& recording : recordings.first(std::min(recordings.size(), static_cast<std::size_t>(most)))) {
        all.append(QString::fromStdString(recording.string()));
    }
    all.removeDuplicates();
    std::vector<RecentWork> found;
    for (const QString& text : all) {
        const RecentFile recent = RecentFile::fromText(text);
        const QFileInfo facts(recent.files.front());
        if (facts.exists()) found.push_back({text, titleOf(facts), kindOf(recent), facts.lastModified()});
    }
    std::ranges::stable_sort(found, std::greater(), &RecentWork::time);
    return found;
}

}  // namespace tactooth
