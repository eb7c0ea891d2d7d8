// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/thumbnail_store.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>
#include <QUrl>

namespace tactooth {
namespace {

constexpr const char* kUriKey = "Thumb::URI";
constexpr const char* kTimeKey = "Thumb::MTime";

QByteArray uriOf(const QString& file) { return QUrl::fromLocalFile(QFileInfo(file).absoluteFilePath()).toEncoded(); }

/// Of the last change, in seconds as the standard asks.
QString timeOf(const QString& file) { return QString::number(QFileInfo(file).lastModified().toSecsSinceEpoch()); }

}  // namespace

ThumbnailStore::ThumbnailStore()
    : folder_(QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + "/thumbnails/large") {}

QString ThumbnailStore::pathOf(const QString& file) const {
    const QByteArray name = QCryptographicHash::hash(uriOf(file), QCryptographicHash::Md5).toHex();
    return QString("%1/%2.png").arg(folder_, QString::fromLatin1(name));
}

void ThumbnailStore::save(const QString& file, const QImage& picture) const {
    if (picture.isNull() || !QFileInfo::exists(file)) return;
    QImage small = picture.scaled(kSize, kSize, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    small.setText(kUriKey, QString::fromLatin1(uriOf(file)));
    small.setText(kTimeKey, timeOf(file));
    small.setText("Software", "Tactooth");
    QDir().mkpath(folder_);
    QFile::setPermissions(folder_, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    QSaveFile out(pathOf(file));
    if (!out.open(QIODevice::WriteOnly)) return;
    out.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    if (small.save(&out, "PNG")) out.commit();
}

QImage ThumbnailStore::load(const QString& file) const {
    const QImage found(pathOf(file), "PNG");
    return found.text(kTimeKey) == timeOf(file) && found.text(kUriKey).toLatin1() == uriOf(file) ? found : QImage();
}

}  // namespace tactooth
