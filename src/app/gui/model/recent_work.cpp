// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/recent_work.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <algorithm>

#include "app/gui/text/translation.h"
#include "session/cases/case_store.h"
#include "session/recording/session_recording.h"

namespace tactooth {
namespace {

RecentWork::Kind kindOf(const QString& file) {
    const std::filesystem::path path = file.toStdString();
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
    for (const QString& file : all) {
        const QFileInfo facts(file);
        if (facts.exists()) found.push_back({file, titleOf(facts), kindOf(file), facts.lastModified()});
    }
    std::ranges::stable_sort(found, std::greater(), &RecentWork::time);
    return found;
}

}  // namespace tactooth
