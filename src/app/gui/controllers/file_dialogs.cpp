// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/file_dialogs.h"

#include <QFileInfo>
#include <utility>

namespace tactooth {

void FileDialogs::enterFolderOf(const QString& file) { folder_ = QFileInfo(file).absolutePath(); }

QFileDialog* FileDialogs::make(const QString& title, const QString& filter, QFileDialog::FileMode mode) const {
    auto* dialog = new QFileDialog(&window_, title, folder_, filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(mode);
    return dialog;
}

void FileDialogs::open(const QString& title, const QString& filter, FileChosen chosen) const {
    QFileDialog* dialog = make(title, filter, QFileDialog::ExistingFile);
    QObject::connect(dialog, &QFileDialog::fileSelected, dialog, std::move(chosen));
    dialog->open();
}

void FileDialogs::openSeveral(const QString& title, const QString& filter, FilesChosen chosen) const {
    QFileDialog* dialog = make(title, filter, QFileDialog::ExistingFiles);
    QObject::connect(dialog, &QFileDialog::filesSelected, dialog, std::move(chosen));
    dialog->open();
}

void FileDialogs::openFolder(const QString& title, FileChosen chosen) const {
    QFileDialog* dialog = make(title, QString(), QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    QObject::connect(dialog, &QFileDialog::fileSelected, dialog, std::move(chosen));
    dialog->open();
}

void FileDialogs::save(const QString& title, const QString& filter, const QString& name, FileChosen chosen) const {
    QFileDialog* dialog = make(title, filter, QFileDialog::AnyFile);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QFileInfo(name).suffix());
    dialog->selectFile(name);
    QObject::connect(dialog, &QFileDialog::fileSelected, dialog, std::move(chosen));
    dialog->open();
}

}  // namespace tactooth
