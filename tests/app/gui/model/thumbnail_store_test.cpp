// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/thumbnail_store.h"

#include <gtest/gtest.h>

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

QImage striped() {
    QImage image(640, 480, QImage::Format_RGB32);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) image.setPixelColor(x, y, x < 320 ? Qt::red : Qt::blue);
    }
    return image;
}

class ThumbnailStoreTest : public testing::Test {
protected:
    [[nodiscard]] QString write(const char* name, const char* text) const {
        const auto path = folder_ / name;
        test::writeText(path, text);
        return QString::fromStdString(path.string());
    }
    [[nodiscard]] ThumbnailStore store() const { return ThumbnailStore(thumbnails()); }
    [[nodiscard]] QString thumbnails() const {
        return QString::fromStdString((folder_ / "cache" / "thumbnails" / "large").string());
    }

    test::TemporaryFolder folder_;
};

TEST_F(ThumbnailStoreTest, APictureComesBackSmaller) {
    const QString file = write("tooth.stl", "solid");
    store().save(file, striped());
    const QImage found = store().load(file);
    ASSERT_EQ(found.size(), QSize(256, 192));
    EXPECT_EQ(found.pixelColor(20, 90), QColor(Qt::red));
    EXPECT_EQ(found.pixelColor(240, 90), QColor(Qt::blue));
}

/// Other programs find it: the name, the two texts and the rights are those of the standard.
TEST_F(ThumbnailStoreTest, ItIsThatOfTheStandard) {
    const QString file = write("a tooth.stl", "solid");
    store().save(file, striped());
    const QByteArray uri = "file://" + file.toUtf8().replace(' ', "%20");
    const QString name = QCryptographicHash::hash(uri, QCryptographicHash::Md5).toHex() + ".png";
    const QString path = thumbnails() + '/' + name;
    ASSERT_TRUE(QFile::exists(path)) << qPrintable(path);
    const QImage image(path);
    EXPECT_EQ(image.text("Thumb::URI").toUtf8(), uri);
    EXPECT_EQ(image.text("Thumb::MTime").toLongLong(), QFileInfo(file).lastModified().toSecsSinceEpoch());
    constexpr auto kOthers = QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
    EXPECT_FALSE(QFile::permissions(path) & kOthers) << "a patient's tooth is for its user alone";
}

TEST_F(ThumbnailStoreTest, AFileThatHasChangedHasNone) {
    const QString file = write("tooth.stl", "solid");
    store().save(file, striped());
    QFile changed(file);
    ASSERT_TRUE(changed.open(QIODevice::ReadWrite));
    ASSERT_TRUE(changed.setFileTime(QDateTime::fromSecsSinceEpoch(1), QFile::FileModificationTime));
    changed.close();
    EXPECT_TRUE(store().load(file).isNull());
}

TEST_F(ThumbnailStoreTest, NothingHarms) {
    EXPECT_TRUE(store().load("/no/such/file").isNull());
    store().save("/no/such/file", striped());
    const QString file = write("tooth.stl", "solid");
    store().save(file, {});
    EXPECT_TRUE(store().load(file).isNull());
    test::writeText(folder_ / "wall", "not a folder");
    const ThumbnailStore blocked(QString::fromStdString((folder_ / "wall" / "large").string()));
    blocked.save(file, striped());
    EXPECT_TRUE(blocked.load(file).isNull());
}

}  // namespace
}  // namespace tactooth
