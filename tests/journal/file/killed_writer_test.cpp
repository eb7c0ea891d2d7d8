// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// kill -9 at any moment of a recording: the file opens, and lacks no more than half a second and one sync.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <new>
#include <random>

#include "geometry/util/byte_stream.h"
#include "journal/file/journal_reader.h"
#include "journal/file/journal_writer.h"
#include "journal_samples.h"
#include "support/sanitizer.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

/// What the child has appended, in memory that outlives it.
struct Appended {
    std::atomic<std::uint64_t> blocks{0};
    std::atomic<std::int64_t> time{0};  ///< of the last block, ns
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

class SharedAppended {
public:
    SharedAppended() {
        void* const place =
            ::mmap(nullptr, sizeof(Appended), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        EXPECT_NE(place, MAP_FAILED);
        appended_ = new (place) Appended;
    }
    ~SharedAppended() { ::munmap(appended_, sizeof(Appended)); }
    SharedAppended(const SharedAppended&) = delete;
    SharedAppended& operator=(const SharedAppended&) = delete;

    [[nodiscard]] Appended& operator*() const { return *appended_; }

private:
    Appended* appended_;
};

/// A block that holds the time at which it was appended, and what a second of a session is like.
JournalBlock stampedBlock(std::uint64_t tick, std::int64_t time, std::span<const std::byte> filling) {
    ByteWriter out;
    out.put(time);
    out.putAll(filling);
    return {BlockType::Events, tick, 1, out.take()};
}

/// Appends for ever; each number in the pipe is a count of blocks that are on the disk.
[[noreturn]] void record(const std::filesystem::path& path, int pipe, unsigned seed, Appended& appended) {
    std::mt19937 random(seed);
    std::vector<std::byte> filling(4000);
    auto writer = JournalWriter::create(path, test::kSampleHeader);
    if (!writer) _exit(1);
    for (std::uint64_t tick = 0;;) {
        for (std::byte& byte : filling) byte = static_cast<std::byte>(random() % 8);
        for (std::uint64_t i = 1 + random() % 60; i > 0; --i) {
            const std::int64_t now = std::chrono::steady_clock::now().time_since_epoch().count();
            if (!(*writer)->appendWhenRoom(stampedBlock(tick++, now, filling))) _exit(2);
            appended.time = now;
            appended.blocks = tick;
        }
        if (!(*writer)->flush() || ::write(pipe, &tick, sizeof tick) != sizeof tick) _exit(3);
    }
}

/// Kills the recording when it has reported `reports` flushes; gives the blocks that it knew to be on the disk.
std::uint64_t killAfter(const std::filesystem::path& path, unsigned reports, unsigned seed, Appended& appended) {
    int ends[2];
    EXPECT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        record(path, ends[1], seed, appended);
    }
    ::close(ends[1]);
    std::uint64_t synced = 0;
    for (unsigned i = 0; i < reports; ++i) {
        if (::read(ends[0], &synced, sizeof synced) != sizeof synced) break;
    }
    ::kill(child, SIGKILL);
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status)) << "it ended by itself: " << WEXITSTATUS(status);
    ::close(ends[0]);
    return synced;
}

void expectNearlyAll(const std::filesystem::path& path, std::uint64_t synced, const Appended& appended) {
    constexpr std::int64_t kMostLost = 1'500'000'000;  // ns: a block of half a second, and a second between two syncs
    if (appended.blocks == 0 && !std::filesystem::exists(path)) return;  // killed before there was a file
    const auto journal = JournalReader::open(path);
    ASSERT_TRUE(journal) << journal.error().message();
    EXPECT_FALSE(journal->isComplete());
    EXPECT_FALSE(isBeingRecorded(path));
    ASSERT_GE(journal->blocks().size(), synced);
    ASSERT_LE(journal->blocks().size(), appended.blocks + 1);
    std::int64_t last = 0;
    for (std::size_t i = 0; i < journal->blocks().size(); ++i) {
        EXPECT_EQ(journal->blocks()[i].header.firstTick, i);
        const auto payload = journal->payload(journal->blocks()[i]);
        ASSERT_TRUE(payload) << payload.error().message();
        last = ByteReader(*payload).get<std::int64_t>();
    }
    if (last != 0) {
        EXPECT_LT(appended.time - last, kMostLost);
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
        const SharedAppended appended;
        const unsigned reports = round % 5 == 0 ? 0 : 1 + random() % 40;
        const std::uint64_t synced = killAfter(folder / "a.ttsession", reports, round, *appended);
        expectNearlyAll(folder / "a.ttsession", synced, *appended);
    }
}

}  // namespace
}  // namespace tactooth
