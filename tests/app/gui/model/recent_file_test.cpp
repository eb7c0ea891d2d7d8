// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/recent_file.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(RecentFile, ALineHoldsAFileOrTheSurfacesOfAScan) {
    for (const RecentFile& recent : {RecentFile{{"/teeth/a b.stl"}}, RecentFile{{"/teeth/scan\twith a tab.stl"}},
                                     RecentFile{{"/a.stl"}, true}, RecentFile{{"/a.stl", "/a_enamel.ply"}, true}}) {
        EXPECT_EQ(RecentFile::fromText(recent.text()), recent) << recent.text().toStdString();
    }
}

TEST(RecentFile, LinesOfEarlierVersionsAreFiles) {
    for (const char* const line : {"/a.stl", "scan", "scan.stl", "/scan/of.stl"}) {
        EXPECT_EQ(RecentFile::fromText(line), (RecentFile{{line}}));
        EXPECT_EQ(RecentFile{{line}}.text(), line);
    }
}

TEST(RecentFile, SurfacesOfScansAreNoOpenedFiles) {
    const QStringList lines = {"/a.stl", RecentFile{{"/b.stl", "/c.stl"}, true}.text(), "/d.tactooth"};
    EXPECT_EQ(openedFiles(lines), (std::vector<std::filesystem::path>{"/a.stl", "/d.tactooth"}));
}

}  // namespace
}  // namespace tactooth
