// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/journal_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cerrno>
#include <csignal>

#include "geometry/util/byte_text.h"
#include "geometry/util/messages.h"
#include "journal/file/messages.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<JournalFile> created(const fs::path& path) {
    Expected<std::unique_ptr<JournalFile>> file = createJournalFile(path);
    EXPECT_TRUE(file) << file.error().message();
    return std::move(*file);
}

TEST(JournalFile, HasNoNameBeforeItIsPublished) {
    const test::TemporaryFolder folder;
    const auto file = created(folder / "a.ttsession");
    EXPECT_EQ(file->write(asBytes("head")).bytes, 4U);
    EXPECT_EQ(file->sync(), 0);
    EXPECT_FALSE(fs::exists(folder / "a.ttsession"));
    EXPECT_EQ(file->publish(), 0);
    EXPECT_EQ(test::readText(folder / "a.ttsession"), "head");
    EXPECT_EQ(file->write(asBytes(" and more")).bytes, 9U);
    EXPECT_EQ(file->sync(), 0);
    EXPECT_EQ(test::readText(folder / "a.ttsession"), "head and more");
}

TEST(JournalFile, LeavesNothingIfItIsNotPublished) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(created(folder / "a.ttsession")->write(asBytes("head")).failure, 0);
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(JournalFile, ReplacesNothing) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "a", "old");
    EXPECT_TRUE(createJournalFile(folder / "a").error().contains(msg::kJournalExists));
    fs::create_symlink("nowhere", folder / "link");
    EXPECT_TRUE(createJournalFile(folder / "link").error().contains(msg::kJournalExists));
    const auto file = created(folder / "b");
    test::writeText(folder / "b", "another was faster");
    EXPECT_EQ(file->publish(), EEXIST);
    EXPECT_EQ(test::readText(folder / "b"), "another was faster");
}

TEST(JournalFile, RefusesAFolderThatItCannotWriteInto) {
    const test::TemporaryFolder folder;
    EXPECT_TRUE(createJournalFile(folder / "none/a").error().contains(msg::kOutputFolderMissing));
    EXPECT_FALSE(createJournalFile(folder.path() / ""));
    EXPECT_FALSE(createJournalFile("/proc/a.ttsession"));
    EXPECT_FALSE(createJournalFile(folder / std::string(300, 'a')));
}

TEST(JournalFile, NoticesThatItWasDeleted) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "in");
    const auto file = created(folder / "in/a.ttsession");
    EXPECT_EQ(file->publish(), 0);
    fs::rename(folder / "in/a.ttsession", folder / "in/b.ttsession");
    EXPECT_EQ(file->sync(), 0) << "it may get another name";
    fs::remove_all(folder / "in");
    EXPECT_EQ(file->sync(), ENOENT);
}

TEST(JournalFile, IsLockedWhileItIsRecorded) {
    const test::TemporaryFolder folder;
    auto file = created(folder / "a.ttsession");
    EXPECT_EQ(file->publish(), 0);
    EXPECT_TRUE(isBeingRecorded(folder / "a.ttsession"));
    EXPECT_TRUE(isBeingRecorded(folder / "a.ttsession")) << "to ask changes nothing";
    file.reset();
    EXPECT_FALSE(isBeingRecorded(folder / "a.ttsession"));
    EXPECT_FALSE(isBeingRecorded(folder / "none"));
}

TEST(JournalFile, ReportsWhatTheSystemSays) {
    const test::TemporaryFolder folder;
    const auto file = created(folder / "a.ttsession");
    const auto before = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
    const rlimit small{10, limit.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const JournalFile::Written part = file->write(asBytes("0123456789abcdef"));
    const JournalFile::Written none = file->write(asBytes("x"));
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
    (void)std::signal(SIGXFSZ, before);
    EXPECT_EQ(part.bytes, 10U);
    EXPECT_EQ(part.failure, 0);
    EXPECT_EQ(none.failure, EFBIG);
}

}  // namespace
}  // namespace tactooth
