// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>

namespace tactooth {

/// Small pictures of the user's files in the folder of thumbnails that desktops share (freedesktop.org, "Thumbnail
/// Managing Standard"). Any thread.
class ThumbnailStore {
public:
    static constexpr int kSize = 256;  ///< pixels of the longer side: the standard's size "large"

    ThumbnailStore();
    /// `folder`: of thumbnails of that size.
    explicit ThumbnailStore(QString folder) : folder_(std::move(folder)) {}

    /// Keeps `picture`, made smaller, for `file` as it is now. A thumbnail that cannot be written is left out: nobody
    /// loses work.
    void save(const QString& file, const QImage& picture) const;
    /// Null if there is none, or if the file has changed since.
    [[nodiscard]] QImage load(const QString& file) const;

private:
    [[nodiscard]] QString pathOf(const QString& file) const;

    QString folder_;
};

}  // namespace tactooth
