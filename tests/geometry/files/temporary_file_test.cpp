// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/temporary_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <set>

#include "geometry/files/atomic_file.h"
#include "geometry/files/staging_folder.h"
#include "geometry/files/unfinished_files.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

std::size_t entriesIn(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

/// A child that leaves named temporary files and folders behind, killed.
void killAWriterIn(const fs::path& folder) {
    const pid_t child = ::fork();
    if (child == 0) {
        TemporaryFile file;
        if (openNamed(folder, file) != 0) _exit(1);
        const auto unfinished = StagingFolder::make(folder);
        std::ofstream(unfinished->path() / "part") << "x";
        ::raise(SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(TemporaryFile, NamesAreDrawnByChance) {
    std::set<fs::path> names;
    for (int i = 0; i < 1000; ++i) {
        const fs::path name = randomNameIn("folder");
        EXPECT_EQ(name.parent_path(), "folder");
        EXPECT_TRUE(isRandomName(name.filename().native())) << name;
        EXPECT_TRUE(names.insert(name).second);
    }
    for (const char* other : {".tactooth-12.tmp", "tactooth-0123456789abcdef.tmp", ".tactooth-0123456789abcdeg.tmp",
                              ".tactooth-0123456789abcdef.tmp2", "", ".tmp"}) {
        EXPECT_FALSE(isRandomName(other)) << other;
    }
}

TEST(TemporaryFile, BothKindsHaveTheModeOfANewFile) {
    const test::TemporaryFolder folder;
    const mode_t before = ::umask(027);
    for (const auto open : {openUnnamed, openNamed}) {
        TemporaryFile file;
        if (open(folder.path(), file) != 0) continue;  // this file system has no unnamed files
        struct stat status {};
        ASSERT_EQ(::fstat(file.descriptor, &status), 0);
        EXPECT_EQ(status.st_mode & 07777, 0640U);
        ::close(file.descriptor);
        ::unlink(file.name.c_str());
        if (!file.name.empty()) unregisterUnfinished(file.name);
    }
    ::umask(before);
}

TEST(TemporaryFile, WhatAKilledWriterLeftIsRemovedByTheNextOneInThatFolder) {
    const test::TemporaryFolder folder;
    killAWriterIn(folder.path());
    EXPECT_EQ(entriesIn(folder.path()), 2U);
    ASSERT_TRUE(writeFile(folder / "out", std::string_view("x")));
    EXPECT_EQ(entriesIn(folder.path()), 1U);
}

TEST(TemporaryFile, WhatALivingWriterHasIsLeftAlone) {
    const test::TemporaryFolder folder;
    TemporaryFile file;
    ASSERT_EQ(openNamed(folder.path(), file), 0);
    {
        const auto unfinished = StagingFolder::make(folder.path());
        ASSERT_TRUE(unfinished);
        removeStale(folder.path());
        EXPECT_EQ(entriesIn(folder.path()), 2U);
    }
    ::close(file.descriptor);
    removeStale(folder.path());
    unregisterUnfinished(file.name);
    EXPECT_EQ(entriesIn(folder.path()), 0U);
}

TEST(TemporaryFile, NothingElseIsRemoved) {
    const test::TemporaryFolder folder;
    for (const char* name : {".tactooth-1-0.tmp", ".tactooth-0123456789ABCDEF.tmp", "a.tmp", ".tactooth-.tmp"}) {
        std::ofstream(folder / name) << "x";
    }
    fs::create_symlink("a.tmp", folder / ".tactooth-0123456789abcdef.tmp");
    removeStale(folder.path());
    EXPECT_EQ(entriesIn(folder.path()), 5U);
}

TEST(StagingFolder, BecomesTheFolderOrMovesItsContentUp) {
    const test::TemporaryFolder folder;
    auto whole = StagingFolder::make(folder.path());
    ASSERT_TRUE(whole);
    std::ofstream(whole->path() / "file") << "x";
    ASSERT_TRUE(whole->renameTo(folder / "whole"));
    EXPECT_TRUE(fs::exists(folder / "whole/file"));

    fs::create_directory(folder / "there");
    {
        auto content = StagingFolder::make(folder / "there");
        ASSERT_TRUE(content);
        for (const char* name : {"a", "b"}) std::ofstream(content->path() / name) << "x";
        fs::create_directory(content->path() / "below");
        ASSERT_TRUE(content->moveUp());
    }
    EXPECT_EQ(entriesIn(folder / "there"), 3U);
    EXPECT_EQ(entriesIn(folder.path()), 2U);
}

/// removeAllUnfinished is for a program that ends: a child of this one.
TEST(UnfinishedNames, AreAllRemovedBeforeTheProgramEnds) {
    const test::TemporaryFolder folder;
    const pid_t child = ::fork();
    if (child == 0) {
        TemporaryFile file;
        if (openNamed(folder.path(), file) != 0) _exit(1);
        const auto unfinished = StagingFolder::make(folder.path());
        std::ofstream(unfinished->path() / "part") << "x";
        fs::create_directories(folder / "made/below");
        fs::create_directories(folder / "used/below");
        std::ofstream(folder / "used/mine") << "x";
        for (const char* name : {"made", "made/below", "used", "used/below"}) {
            registerUnfinished(folder / name, Unfinished::EmptyFolder);
        }
        removeAllUnfinished(1);
        _exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(fs::exists(folder / "used/mine"));
    EXPECT_FALSE(fs::exists(folder / "used/below"));
    EXPECT_EQ(entriesIn(folder.path()), 1U);
}

}  // namespace
}  // namespace tactooth
