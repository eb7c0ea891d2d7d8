// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/file_transaction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>

#include "geometry/files/atomic_file.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string contentOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t entriesIn(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

TEST(FileTransaction, AllFilesGetTheirNamesAtItsCommitAndNotBefore) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "b") << "old";
    FileTransaction set;
    for (const char* name : {"a", "b", "c"}) ASSERT_TRUE(set.open(folder / name));
    for (const char* name : {"a", "b"}) ASSERT_TRUE(writeFile(folder / name, std::string_view(name)));
    EXPECT_FALSE(fs::exists(folder / "a"));
    EXPECT_EQ(contentOf(folder / "b"), "old");
    ASSERT_TRUE(set.commit());
    EXPECT_EQ(contentOf(folder / "a"), "a");
    EXPECT_EQ(contentOf(folder / "b"), "b");
    EXPECT_EQ(entriesIn(folder.path()), 2U) << "c was not written; nothing else is left";
}

TEST(FileTransaction, WithoutCommitAllIsAsItWas) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "b") << "old";
    {
        FileTransaction set;
        ASSERT_TRUE(set.makeFolder(folder / "new/below"));
        for (const char* name : {"a", "b", "new/below/c"}) {
            ASSERT_TRUE(set.open(folder / name));
            ASSERT_TRUE(writeFile(folder / name, std::string_view("x")));
        }
    }
    EXPECT_EQ(contentOf(folder / "b"), "old");
    EXPECT_EQ(entriesIn(folder.path()), 1U);
}

/// A folder that replaces a file after it was opened represents all failures of a rename.
TEST(FileTransaction, WhereOneNameFailsTheOthersAreTakenBack) {
    for (const std::size_t failing : {0U, 1U, 2U, 3U, 4U}) {
        const test::TemporaryFolder folder;
        const std::vector<std::string> names = {"new1", "old1", "new2", "old2", "new3"};
        for (const char* name : {"old1", "old2"}) std::ofstream(folder / name) << "old";
        FileTransaction set;
        for (const std::string& name : names) {
            ASSERT_TRUE(set.open(folder / name));
            ASSERT_TRUE(writeFile(folder / name, std::string_view("new")));
        }
        fs::remove(folder / names[failing]);
        fs::create_directory(folder / names[failing]);
        const auto done = set.commit();
        ASSERT_FALSE(done);
        EXPECT_THAT(done.error().message(), HasSubstr(names[failing] + ": cannot be written: "));
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (i == failing) continue;
            const bool wasThere = names[i].starts_with("old");
            EXPECT_EQ(fs::exists(folder / names[i]), wasThere) << names[i];
            if (wasThere) {
                EXPECT_EQ(contentOf(folder / names[i]), "old");
            }
        }
        EXPECT_EQ(entriesIn(folder.path()), failing == 1 || failing == 3 ? 2U : 3U) << "no backup is left";
    }
}

TEST(FileTransaction, RefusesTheSameFileTwiceHoweverItIsWritten) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "d");
    fs::create_directory_symlink(folder / "d", folder / "way");
    std::ofstream(folder / "there") << "x";
    fs::create_symlink("there", folder / "link");
    fs::create_hard_link(folder / "there", folder / "second");
    fs::create_symlink("d/new", folder / "dangling");
    const std::vector<std::pair<std::string, std::string>> pairs = {
        {"new", "new"},          {"new", "./new"},       {"new", "d/../new"},   {"d/new", "way/new"},
        {"there", "link"},       {"there", "second"},    {"d/new", "dangling"}, {"new", "d/.././new"},
        {"link", "./d/../link"}, {"way/new", "dangling"}};
    for (const auto& [first, second] : pairs) {
        FileTransaction set;
        ASSERT_TRUE(set.open(folder / first)) << first;
        const auto again = set.open(folder / second);
        ASSERT_FALSE(again) << first << " and " << second;
        EXPECT_THAT(again.error().message(), HasSubstr("it is the same file as "));
    }
}

TEST(FileTransaction, RefusesWhatIsRead) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "case");
    std::ofstream(folder / "in.stl") << "x";
    std::ofstream(folder / "case/tooth.stl") << "x";
    fs::create_symlink("in.stl", folder / "link");
    FileTransaction set;
    set.reads(folder / "in.stl");
    set.reads(folder / "case");
    set.reads({});
    for (const char* name : {"in.stl", "./in.stl", "link", "case/tooth.stl"}) {
        const auto opened = set.open(folder / name);
        ASSERT_FALSE(opened) << name;
        EXPECT_THAT(opened.error().message(), HasSubstr("this command reads it (as "));
    }
    EXPECT_TRUE(set.open(folder / "case/new.stl")) << "a new file beside those that are read is allowed";
    EXPECT_EQ(contentOf(folder / "in.stl"), "x");
}

TEST(FileTransaction, TakesTheFilesOfItsOwnPathsAlone) {
    const test::TemporaryFolder folder;
    FileTransaction set;
    ASSERT_TRUE(set.open(folder / "a"));
    ASSERT_TRUE(writeFile(folder / "cache", std::string_view("kept")));
    EXPECT_EQ(contentOf(folder / "cache"), "kept") << "named at once";
}

TEST(FileTransaction, ManyFilesInManyFolders) {
    const test::TemporaryFolder folder;
    FileTransaction set;
    for (int i = 0; i < 150; ++i) {
        const fs::path file = folder / std::to_string(i % 30) / std::to_string(i);
        ASSERT_TRUE(set.makeFolder(file.parent_path()));
        ASSERT_TRUE(set.open(file));
        ASSERT_TRUE(writeFile(file, std::to_string(i)));
    }
    ASSERT_TRUE(set.commit());
    for (int i = 0; i < 150; ++i) {
        EXPECT_EQ(contentOf(folder / std::to_string(i % 30) / std::to_string(i)), std::to_string(i));
    }
}

}  // namespace
}  // namespace tactooth
