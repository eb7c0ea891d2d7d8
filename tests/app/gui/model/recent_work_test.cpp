// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/recent_work.h"

#include <gtest/gtest.h>

#include <QFile>

#include "app/gui/model/recent_file.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

class RecentWorkTest : public testing::Test {
protected:
    /// A file that was changed at this second.
    std::filesystem::path file(const std::string& name, qint64 second) {
        const auto path = folder_ / name;
        test::writeText(path, "content");
        QFile changed(QString::fromStdString(path.string()));
        EXPECT_TRUE(changed.open(QIODevice::ReadWrite));
        EXPECT_TRUE(changed.setFileTime(QDateTime::fromSecsSinceEpoch(second), QFile::FileModificationTime));
        return path;
    }
    static QString name(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }
    static std::vector<QString> titles(const std::vector<RecentWork>& work) {
        std::vector<QString> all;
        for (const RecentWork& one : work) all.push_back(one.title);
        return all;
    }

    test::TemporaryFolder folder_;
};

TEST_F(RecentWorkTest, TheNewestComesFirst) {
    const auto a = file("a.stl", 100), b = file("b.tactooth", 300), c = file("2026-11-29 14.32 Canine.ttsession", 200);
    const std::vector<std::filesystem::path> recordings = {c};
    const auto work = recentWork({name(a), name(b)}, recordings, 8);
    EXPECT_EQ(titles(work), (std::vector<QString>{"b", "Canine", "a"}));
    EXPECT_EQ(work[1].kind, RecentWork::Kind::Recording);
    EXPECT_EQ(work[1].time.toSecsSinceEpoch(), 200);
}

TEST_F(RecentWorkTest, EachKindIsNamed) {
    const auto tooth = file("a.stl", 5), task = file("b.toml", 4), of = file("c.ttcase", 3),
               run = file("d.ttsession", 2);
    const QString scan = RecentFile{{name(file("e.ply", 1)), name(file("e_enamel.ply", 9))}, true}.text();
    const auto work = recentWork({scan, name(tooth), name(task), name(of), name(run)}, {}, 8);
    ASSERT_EQ(work.size(), 5U);
    EXPECT_EQ(work[0].kind, RecentWork::Kind::Tooth);
    EXPECT_EQ(work[1].kind, RecentWork::Kind::Exercise);
    EXPECT_EQ(work[2].kind, RecentWork::Kind::Case);
    EXPECT_EQ(work[3].kind, RecentWork::Kind::Recording);
    EXPECT_EQ(work[4], (RecentWork{scan, "e", RecentWork::Kind::Scan, QDateTime::fromSecsSinceEpoch(1)}));
}

TEST_F(RecentWorkTest, WhatHasGoneIsLeftOutAndNothingComesTwice) {
    const auto run = file("2026-11-29 14.32 Canine.ttsession", 5), gone = folder_ / "gone.stl";
    const std::vector<std::filesystem::path> recordings = {run, folder_ / "2026-11-29 14.33 Gone.ttsession"};
    EXPECT_EQ(titles(recentWork({name(gone), name(run)}, recordings, 8)), std::vector<QString>{"Canine"});
}

TEST_F(RecentWorkTest, ItIsLimited) {
    QStringList files;
    std::vector<std::filesystem::path> recordings;
    for (int i = 0; i < 5; ++i) {
        files << name(file("tooth" + std::to_string(i) + ".stl", 10 + i));
        recordings.push_back(file("2026-11-29 14.3" + std::to_string(i) + " Canine.ttsession", 20 + i));
    }
    EXPECT_EQ(recentWork(files, recordings, 3).size(), 6U);
    EXPECT_EQ(recentWork(files, recordings, 0).size(), 0U);
}

}  // namespace
}  // namespace tactooth
