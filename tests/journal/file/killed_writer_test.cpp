// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// kill -9 at any moment of a recording: the file opens, and lacks no more than half a second and one sync.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>

#include "geometry/util/byte_stream.h"
#include "journal/file/journal_reader.h"
#include "journal/file/journal_writer.h"
#include "journal_samples.h"
#include "support/sanitizer.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

/// Of all processes; the clock of day may be set.
std::int64_t nowNs() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

/// A block that holds the time at which it was appended, and what a second of a session is like.
JournalBlock stampedBlock(std::uint64_t tick, std::span<const std::byte> filling) {
    ByteWriter out;
    out.put(nowNs());
    out.putAll(filling);
    return {BlockType::Events, tick, 1, out.take()};
}

/// Appends for ever; each number in the pipe is a count of blocks that are on the disk.
[[noreturn]] void record(const std::filesystem::path& path, int pipe, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::byte> filling(4000);
    auto writer = JournalWriter::create(path, test::kSampleHeader);
    if (!writer) _exit(1);
    for (std::uint64_t tick = 0;;) {
        for (std::byte& byte : filling) byte = static_cast<std::byte>(random() % 8);
        for (std::uint64_t i = 1 + random() % 20; i > 0; --i) {
            if (!(*writer)->appendWhenRoom(stampedBlock(tick++, filling))) _exit(2);
        }
        if (!(*writer)->flush() || ::write(pipe, &tick, sizeof tick) != sizeof tick) _exit(3);
    }
}

struct Killed {
    std::uint64_t synced = 0;  ///< blocks that the child knew to be on the disk
    std::int64_t time = 0;     ///< of the kill
};

/// Kills the recording when it has told of `reports` flushes.
Killed killAfter(const std::filesystem::path& path, unsigned reports, unsigned seed) {
    int ends[2];
    EXPECT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        record(path, ends[1], seed);
    }
    ::close(ends[1]);
    Killed killed;
    for (unsigned i = 0; i < reports; ++i) {
        if (::read(ends[0], &killed.synced, sizeof killed.synced) != sizeof killed.synced) break;
    }
    killed.time = nowNs();
    ::kill(child, SIGKILL);
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status)) << "it ended by itself: " << WEXITSTATUS(status);
    ::close(ends[0]);
    return killed;
}

void expectNearlyAll(const std::filesystem::path& path, const Killed& killed) {
    constexpr std::int64_t kMostLost = 1'500'000'000;  // ns: a block of half a second, and a second between two syncs
    if (killed.synced == 0 && !std::filesystem::exists(path)) return;  // killed before there was a file
    const auto journal = JournalReader::open(path);
    ASSERT_TRUE(journal) << journal.error().message();
    EXPECT_FALSE(journal->isComplete());
    EXPECT_FALSE(isBeingRecorded(path));
    ASSERT_GE(journal->blocks().size(), killed.synced);
    std::int64_t last = 0;
    for (std::size_t i = 0; i < journal->blocks().size(); ++i) {
        EXPECT_EQ(journal->blocks()[i].header.firstTick, i);
        const auto payload = journal->payload(journal->blocks()[i]);
        ASSERT_TRUE(payload) << payload.error().message();
        last = ByteReader(*payload).get<std::int64_t>();
    }
    if (killed.synced > 0) {
        EXPECT_LT(killed.time - last, kMostLost);
    }
}

/// TACTOOTH_KILLS is for a long run before a release.
unsigned kills() {
    const char* const wanted = std::getenv("TACTOOTH_KILLS");
    return wanted != nullptr ? static_cast<unsigned>(std::strtoul(wanted, nullptr, 10)) : test::cases(30U, 5U);
}

TEST(KilledWriter, TheFileOpensAndLacksNoMoreThanItMay) {
    std::mt19937 random(81);
    for (unsigned round = 0; round < kills() && !HasFailure(); ++round) {
        const test::TemporaryFolder folder;
        const unsigned reports = round % 5 == 0 ? 0 : 1 + random() % 40;
        expectNearlyAll(folder / "a.ttsession", killAfter(folder / "a.ttsession", reports, round));
    }
}

}  // namespace
}  // namespace tactooth
