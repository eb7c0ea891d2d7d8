// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/station_key.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>

#include "session/recording/messages.h"
#include "support/scoped_variable.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

mode_t modeOf(const fs::path& file) {
    struct stat status {};
    EXPECT_EQ(::stat(file.c_str(), &status), 0);
    return status.st_mode & 07777U;
}

std::size_t filesIn(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(StationKey, IsInTheUsersFolderForData) {
    const test::ScopedVariable home("HOME", "/home/somebody");
    const test::ScopedVariable data("XDG_DATA_HOME", "/data");
    EXPECT_EQ(stationKeyFile(), "/data/tactooth/station.key");
    const test::ScopedVariable relative("XDG_DATA_HOME", std::nullopt), nowhere("HOME", std::nullopt);
    EXPECT_EQ(stationKeyFile(), "");
    const auto station = openStationKey();
    ASSERT_FALSE(station);
    EXPECT_TRUE(station.error().contains(msg::kStationKeyNowhere));
}

TEST(StationKey, IsMadeOnceAndStays) {
    const test::TemporaryFolder home;
    const fs::path file = home / "a/b/station.key";
    EXPECT_FALSE(knownStationKey(file));
    EXPECT_FALSE(fs::exists(file));
    const auto made = openStationKey(file);
    ASSERT_TRUE(made) << made.error().message();
    EXPECT_TRUE(made->isNew);
    EXPECT_EQ(made->file, file);
    const auto again = openStationKey(file);
    ASSERT_TRUE(again) << again.error().message();
    EXPECT_FALSE(again->isNew);
    EXPECT_EQ(again->key->publicKey(), made->key->publicKey());
    EXPECT_EQ(again->key->seed(), made->key->seed());
    EXPECT_EQ(knownStationKey(file), made->key->publicKey());
    EXPECT_EQ(filesIn(file.parent_path()), 1U);
}

TEST(StationKey, OnlyTheUserCanReadItWhateverTheUmask) {
    const test::TemporaryFolder home;
    const mode_t before = ::umask(0);
    const auto made = openStationKey(home / "station.key");
    ::umask(before);
    ASSERT_TRUE(made) << made.error().message();
    EXPECT_EQ(modeOf(home / "station.key"), 0600U);
}

TEST(StationKey, AFileThatOthersCanReadIsRefused) {
    const test::TemporaryFolder home;
    const fs::path file = home / "station.key";
    ASSERT_TRUE(openStationKey(file));
    for (const mode_t mode : {0640U, 0604U, 0620U}) {
        ASSERT_EQ(::chmod(file.c_str(), mode), 0);
        const auto station = openStationKey(file);
        ASSERT_FALSE(station);
        EXPECT_TRUE(station.error().contains(msg::kStationKeyReadable));
        EXPECT_THAT(station.error().message(), HasSubstr("station.key"));
        EXPECT_FALSE(knownStationKey(file));
    }
    ASSERT_EQ(::chmod(file.c_str(), 0600), 0);
    EXPECT_TRUE(openStationKey(file));
}

TEST(StationKey, ADamagedFileHasOneSentenceAndStays) {
    const test::TemporaryFolder home;
    const fs::path file = home / "station.key";
    ASSERT_TRUE(openStationKey(file));
    const std::string good = test::readText(file);
    const std::string secret = good.substr(good.size() - 65, 64);
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string damaged = good;
        damaged[i] = damaged[i] == '0' ? '1' : '0';
        for (const std::string& text : {damaged, good.substr(0, i), good + "x"}) {
            test::writeText(file, text);
            const auto station = openStationKey(file);
            ASSERT_FALSE(station) << i;
            EXPECT_THAT(station.error().message(), HasSubstr("station.key"));
            EXPECT_THAT(station.error().message(), Not(HasSubstr(secret)));
            EXPECT_FALSE(knownStationKey(file));
            ASSERT_EQ(test::readText(file), text) << "a key is never replaced";
        }
    }
    test::writeText(file, good);
    EXPECT_TRUE(openStationKey(file));
}

TEST(StationKey, AFolderThatCannotBeMadeHasItsSentence) {
    const test::TemporaryFolder home;
    test::writeText(home / "file", "x");
    const auto station = openStationKey(home / "file/tactooth/station.key");
    ASSERT_FALSE(station);
    EXPECT_THAT(station.error().message(), HasSubstr("station.key"));
}

/// Programs that make it at the same time all get the one that is in the file.
TEST(StationKey, IsTheSameForAllThatBeginAtOnce) {
    for (int round = 0; round < 10; ++round) {
        const test::TemporaryFolder home;
        const fs::path file = home / "tactooth/station.key";
        int start[2], result[2];
        ASSERT_EQ(::pipe(start), 0);
        ASSERT_EQ(::pipe(result), 0);
        constexpr int kPrograms = 8;
        std::vector<pid_t> children;
        for (int i = 0; i < kPrograms; ++i) {
            const pid_t child = ::fork();
            ASSERT_GE(child, 0);
            if (child == 0) {
                char go = 0;
                ::close(start[1]);
                (void)!::read(start[0], &go, 1);  // ends when the parent closes the pipe
                const auto station = openStationKey(file);
                if (station) (void)!::write(result[1], station->key->publicKey().bytes.data(), 32);
                ::_exit(station ? 0 : 1);
            }
            children.push_back(child);
        }
        ::close(start[0]);
        ::close(start[1]);
        ::close(result[1]);
        for (const pid_t child : children) {
            int status = 0;
            ASSERT_EQ(::waitpid(child, &status, 0), child);
            EXPECT_EQ(status, 0);
        }
        std::set<std::array<std::byte, 32>> keys;
        std::array<std::byte, 32> key{};
        int count = 0;
        for (; ::read(result[0], key.data(), key.size()) == 32; ++count) keys.insert(key);
        ::close(result[0]);
        EXPECT_EQ(count, kPrograms);
        ASSERT_EQ(keys.size(), 1U);
        EXPECT_EQ(knownStationKey(file)->bytes, *keys.begin());
        EXPECT_EQ(filesIn(file.parent_path()), 1U);
    }
}

}  // namespace
}  // namespace tactooth
