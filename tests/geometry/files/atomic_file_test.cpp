// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>

#include "geometry/files/temporary_file.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

std::string contentOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t filesIn(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(AtomicFile, HasItsNameOnlyAfterCommit) {
    const test::TemporaryFolder folder;
    Expected<AtomicFile> file = AtomicFile::create(folder / "out.txt");
    ASSERT_TRUE(file) << file.error().message();
    file->write("hello ");
    file->write("world");
    EXPECT_FALSE(std::filesystem::exists(folder / "out.txt"));
    ASSERT_TRUE(file->commit());
    EXPECT_EQ(contentOf(folder / "out.txt"), "hello world");
    EXPECT_EQ(filesIn(folder.path()), 1U);
}

TEST(AtomicFile, WithoutCommitNothingIsLeftAndTheOldFileStays) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "out.txt") << "old";
    {
        Expected<AtomicFile> file = AtomicFile::create(folder / "out.txt");
        ASSERT_TRUE(file);
        file->write(std::string(200000, 'x'));
    }
    EXPECT_EQ(contentOf(folder / "out.txt"), "old");
    EXPECT_EQ(filesIn(folder.path()), 1U);
}

TEST(AtomicFile, LargeAndSmallWritesKeepTheirOrder) {
    const test::TemporaryFolder folder;
    Expected<AtomicFile> file = AtomicFile::create(folder / "out.txt");
    ASSERT_TRUE(file);
    std::string expected;
    for (const std::size_t size :
         {std::size_t{1}, std::size_t{70000}, std::size_t{3}, std::size_t{65536}, std::size_t{40000}}) {
        const std::string part(size, static_cast<char>('a' + expected.size() % 26));
        file->write(part);
        expected += part;
    }
    ASSERT_TRUE(file->commit());
    EXPECT_EQ(contentOf(folder / "out.txt"), expected);
}

TEST(AtomicFile, FollowsASymbolicLink) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "real.txt") << "old";
    std::filesystem::create_symlink(folder / "real.txt", folder / "link.txt");
    ASSERT_TRUE(writeFile(folder / "link.txt", std::as_bytes(std::span("new", 3))));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(contentOf(folder / "real.txt"), "new");
}

TEST(AtomicFile, ALinkToNothingYetLeadsToTheNewFile) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "d");
    std::filesystem::create_symlink("d/real.txt", folder / "link.txt");
    ASSERT_TRUE(writeFile(folder / "link.txt", std::string_view("new")));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(contentOf(folder / "d/real.txt"), "new");
}

TEST(AtomicFile, TheModeOfWhatIsReplacedIsKept) {
    const test::TemporaryFolder folder;
    for (const mode_t mode : {0600U, 0644U, 0664U, 0755U, 0640U}) {
        std::ofstream(folder / "out.txt") << "old";
        ASSERT_EQ(::chmod((folder / "out.txt").c_str(), mode), 0);
        ASSERT_TRUE(writeFile(folder / "out.txt", std::string_view("new")));
        struct stat status {};
        ASSERT_EQ(::stat((folder / "out.txt").c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 07777, mode);
        EXPECT_EQ(contentOf(folder / "out.txt"), "new");
    }
}

TEST(AtomicFile, ANewFileHasTheModeThatTheUserWants) {
    const test::TemporaryFolder folder;
    for (const mode_t mask : {022U, 077U, 002U, 0U, 027U}) {
        const mode_t before = ::umask(mask);
        const std::filesystem::path file = folder / std::to_string(mask);
        ASSERT_TRUE(writeFile(file, std::string_view("new")));
        ::umask(before);
        struct stat status {};
        ASSERT_EQ(::stat(file.c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 07777, 0666U & ~mask);
    }
}

TEST(AtomicFile, TheOwnerOfWhatIsReplacedIsKept) {
    if (::geteuid() != 0) GTEST_SKIP() << "only the superuser replaces files of others";
    const test::TemporaryFolder folder;
    std::ofstream(folder / "out.txt") << "old";
    ASSERT_EQ(::chown((folder / "out.txt").c_str(), 1234, 4321), 0);
    ASSERT_TRUE(writeFile(folder / "out.txt", std::string_view("new")));
    struct stat status {};
    ASSERT_EQ(::stat((folder / "out.txt").c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, 1234U);
    EXPECT_EQ(status.st_gid, 4321U);
}

TEST(AtomicFile, AnotherNameOfWhatIsReplacedKeepsTheOldContent) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "out.txt") << "old";
    std::filesystem::create_hard_link(folder / "out.txt", folder / "other.txt");
    ASSERT_TRUE(writeFile(folder / "out.txt", std::string_view("new")));
    EXPECT_EQ(contentOf(folder / "out.txt"), "new");
    EXPECT_EQ(contentOf(folder / "other.txt"), "old");
}

TEST(AtomicFile, WhileItIsWrittenNothingIsToBeSeen) {
    const test::TemporaryFolder folder;
    TemporaryFile probe;
    if (openUnnamed(folder.path(), probe) != 0) GTEST_SKIP() << "this file system has no unnamed files";
    ::close(probe.descriptor);
    Expected<AtomicFile> file = AtomicFile::create(folder / "out.txt");
    ASSERT_TRUE(file);
    file->write(std::string(200000, 'x'));
    EXPECT_EQ(filesIn(folder.path()), 0U);
}

TEST(AtomicFile, AFileOfTheNameOfAnOldTemporaryOneIsNoObstacle) {
    const test::TemporaryFolder folder;
    for (int i = 0; i < 10; ++i) {
        std::ofstream(folder / (".tactooth-" + std::to_string(::getpid()) + "-" + std::to_string(i) + ".tmp")) << "x";
    }
    EXPECT_TRUE(writeFile(folder / "out.txt", std::string_view("new")));
}

TEST(AtomicFile, RefusesANameThatCannotBeBeforeAnythingIsWritten) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "file") << "x";
    std::filesystem::create_symlink("round", folder / "round");
    const std::vector<std::pair<std::string, std::string>> wrong = {
        {std::string(300, 'a'), "File name too long"}, {"file/below", "its folder does not exist"},
        {"none/below", "its folder does not exist"},   {"round", "Too many levels of symbolic links"},
        {"none/", "its folder does not exist"},        {"..", "this is a folder"}};
    for (const auto& [name, sentence] : wrong) {
        const auto file = AtomicFile::create(folder / name);
        ASSERT_FALSE(file) << name;
        EXPECT_THAT(file.error().message(), ::testing::HasSubstr(sentence)) << name;
    }
}

TEST(AtomicFile, RefusesAFolderAndADevice) {
    const test::TemporaryFolder folder;
    EXPECT_THAT(AtomicFile::create(folder.path()).error().message(), ::testing::HasSubstr("this is a folder"));
    EXPECT_THAT(AtomicFile::create("/dev/null").error().message(), ::testing::HasSubstr("not a regular file"));
}

TEST(AtomicFile, RefusesAFolderThatTheUserMayNotWrite) {
    const test::TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_read |
                                                    std::filesystem::perms::owner_exec |
                                                    std::filesystem::perms::others_exec);
    constexpr uid_t kNobody = 65534;  // root may write everywhere, so the test changes its user for a moment
    const bool steppedDown = ::geteuid() == 0 && ::seteuid(kNobody) == 0;
    const Expected<AtomicFile> file = AtomicFile::create(folder / "out.txt");
    ASSERT_TRUE(!steppedDown || ::seteuid(0) == 0);
    ASSERT_FALSE(file);
    EXPECT_THAT(file.error().message(), ::testing::HasSubstr("this user may not write into its folder"));
}

TEST(AtomicFile, AFullDiskIsAnErrorAndLeavesNothing) {
    const test::TemporaryFolder folder;
    Expected<AtomicFile> file = AtomicFile::create(folder / "out.txt");
    ASSERT_TRUE(file);
    // A limit on file size replaces a full disk: write() fails in the same way.
    rlimit old{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
    const rlimit small{1000, old.rlim_max};
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    file->write(std::string(100000, 'x'));
    const Expected<void> committed = file->commit();
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old), 0);
    std::signal(SIGXFSZ, oldHandler);
    ASSERT_FALSE(committed);
    EXPECT_THAT(committed.error().message(), ::testing::HasSubstr("out.txt: cannot be written"));
    EXPECT_EQ(filesIn(folder.path()), 0U);
}

}  // namespace
}  // namespace tactooth
