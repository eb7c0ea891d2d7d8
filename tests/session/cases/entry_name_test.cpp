// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/entry_name.h"

#include <gtest/gtest.h>

#include <string>

namespace tactooth {
namespace {

TEST(EntryName, SafeEntriesStayInside) {
    for (const char* const path : {"case.toml", "teeth/36/outer.stl", "a b.stl", "\xe6\xad\xaf.stl", "a..b", "a//b",
                                   "./a", "a/.", "a\\b", "a:b", "ab:/c", "a/c:/d"}) {
        EXPECT_TRUE(isSafeEntry(path)) << path;
    }
    for (const char* const path : {"", "/etc/passwd", "../x", "a/../../x", "a/", ".", "./", "C:/x", "c:", "C:\\x",
                                   "\\x", "\\\\server\\x", "a\\..\\x", "a\nb", "a\x1b[2J", "..", "a/.."}) {
        EXPECT_FALSE(isSafeEntry(path)) << path;
    }
    EXPECT_TRUE(isSafeEntry(std::string(1000, 'a')));
    EXPECT_FALSE(isSafeEntry(std::string(1001, 'a')));
    EXPECT_FALSE(isSafeEntry(std::string_view("a\0b", 3)));
}

TEST(EntryName, IsTheSameHoweverItIsWritten) {
    for (const char* const path : {"teeth/36/outer.stl", "./teeth/36/outer.stl", "teeth\\36\\outer.stl",
                                   ".\\teeth\\36/outer.stl", "teeth//36/./outer.stl"}) {
        EXPECT_EQ(entryName(path).name, "teeth/36/outer.stl");
    }
}

TEST(EntryName, OnlyWhatLeadsOutPointsOut) {
    for (const char* const path : {"../a", "a/../b", "/a", "\\a", "C:\\a", "x:/a", ".."})
        EXPECT_EQ(entryName(path).fault, EntryFault::PathTraversal) << path;
    EXPECT_EQ(entryName(std::string(2000, 'a')).fault, EntryFault::TooLong);
    EXPECT_EQ(entryName("a\tb").fault, EntryFault::ControlCharacter);
    EXPECT_EQ(entryName("a/").fault, EntryFault::NoFile);
}

TEST(EntryName, ForeignFilesAreRecognisedByTheirNames) {
    for (const char* const name : {"._36.stl", ".DS_Store", "Thumbs.db", "thumbs.DB", "desktop.ini", "Desktop.ini",
                                   "__MACOSX", ".hidden", "Icon\r"}) {
        EXPECT_TRUE(isSystemFile(name)) << name;
        EXPECT_TRUE(isSystemEntry(std::string("a/") + name)) << name;
        EXPECT_TRUE(isSystemEntry(std::string(name) + "/36.stl")) << name;
    }
    for (const char* const name : {"36.stl", "_36.stl", "Thumbs.stl", "MACOSX", "..", ".", ""})
        EXPECT_FALSE(isSystemFile(name)) << name;
}

}  // namespace
}  // namespace tactooth
