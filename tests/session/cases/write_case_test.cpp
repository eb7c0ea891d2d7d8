// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/write_case.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "session/cases/block_case.h"
#include "session/cases/open_case.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A case whose last file cannot be written: a folder would have to stand where a file is.
std::vector<CaseFile> brokenCase() {
    auto files = test::blockCase();
    files.push_back({"bone.stl/more.stl", bytesOf("x")});
    return files;
}

std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
    return names;
}

TEST(WriteCase, ANewFolderAppearsWithAllItsFilesAndOpens) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeCase(test::blockCase(), folder / "new/case"));
    EXPECT_TRUE(openCase(folder / "new/case"));
    EXPECT_THAT(namesIn(folder / "new"), ElementsAre("case"));
    ASSERT_TRUE(writeCase(test::blockCase(), folder / "slash/"));
    EXPECT_TRUE(openCase(folder / "slash"));
}

TEST(WriteCase, AnEmptyFolderIsFilledAndStaysTheSame) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "empty");
    fs::permissions(folder / "empty", fs::perms::owner_all);
    ASSERT_TRUE(writeCase(test::blockCase(), folder / "empty"));
    EXPECT_TRUE(openCase(folder / "empty"));
    EXPECT_EQ(fs::status(folder / "empty").permissions(), fs::perms::owner_all);
}

TEST(WriteCase, WhatIsThereAlreadyStays) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeCase(test::blockCase(), folder / "case"));
    std::ofstream(folder / "file") << "mine";
    for (const char* const name : {"case", "file"}) {
        const auto again = writeCase(test::blockCase(), folder / name);
        ASSERT_FALSE(again);
        EXPECT_THAT(again.error().message(), HasSubstr("there is something already"));
    }
    EXPECT_EQ(fs::file_size(folder / "file"), 4u);
}

TEST(WriteCase, AFailureLeavesNoFolderBehind) {
    const test::TemporaryFolder folder;
    const auto written = writeCase(brokenCase(), folder / "case");
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().message(), HasSubstr((folder / "case").string() + "/bone.stl"));
    EXPECT_THAT(written.error().message(), Not(HasSubstr(".tmp")));
    EXPECT_THAT(namesIn(folder.path()), IsEmpty());
}

TEST(WriteCase, AFailureLeavesAnEmptyFolderEmpty) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "case");
    ASSERT_FALSE(writeCase(brokenCase(), folder / "case"));
    EXPECT_THAT(namesIn(folder.path()), ElementsAre("case"));
    EXPECT_THAT(namesIn(folder / "case"), IsEmpty());
}

TEST(WriteCase, AFolderThatCannotBeMadeIsNamed) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "file") << "mine";
    const auto written = writeCase(test::blockCase(), folder / "file/case");
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().message(), HasSubstr("file/case"));
    fs::create_symlink(folder / "nowhere", folder / "link");
    EXPECT_FALSE(writeCase(test::blockCase(), folder / "link"));
    EXPECT_EQ(namesIn(folder.path()).size(), 2u);
}

TEST(WriteCase, AnArchiveIsWrittenByItsEnding) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeCase(test::blockCase(), folder / "blocks.ttcase"));
    EXPECT_TRUE(fs::is_regular_file(folder / "blocks.ttcase"));
    EXPECT_TRUE(openCase(folder / "blocks.ttcase"));
}

}  // namespace
}  // namespace tactooth
