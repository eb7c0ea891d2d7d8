// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileDialog>
#include <functional>

namespace tactooth {

/// The window's dialogs for files. They begin in the folder of the last file, and return at once: a function receives
/// the user's choice later.
class FileDialogs {
public:
    /// `window` outlives the dialogs.
    explicit FileDialogs(QWidget& window) : window_(window) {}

    [[nodiscard]] const QString& folder() const { return folder_; }
    void setFolder(const QString& folder) { folder_ = folder; }
    /// `file`: that was opened or written.
    void enterFolderOf(const QString& file);

    using FileChosen = std::function<void(const QString& file)>;
    using FilesChosen = std::function<void(const QStringList& files)>;
    void open(const QString& title, const QString& filter, FileChosen chosen) const;
    void openSeveral(const QString& title, const QString& filter, FilesChosen chosen) const;
    void openFolder(const QString& title, FileChosen chosen) const;
    /// Proposes `name`; a file without a suffix gets that of `name`.
    void save(const QString& title, const QString& filter, const QString& name, FileChosen chosen) const;

private:
    [[nodiscard]] QFileDialog* make(const QString& title, const QString& filter, QFileDialog::FileMode mode) const;

    QWidget& window_;
    QString folder_;
};

}  // namespace tactooth
