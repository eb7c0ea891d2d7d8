// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "geometry/util/expected.h"
#include "journal/file/block_queue.h"
#include "journal/file/journal_appender.h"
#include "journal/file/journal_file.h"
#include "journal/format/journal_block.h"

namespace tactooth {

/// Records blocks into a file from a thread of its own. A block is written at once, and is on the disk (fdatasync) at
/// most `syncPeriod` later, so a kill loses nothing that was appended some milliseconds ago, and a power failure no
/// more than that period. All functions are for any thread but the servo's: they take a lock, though they never wait
/// for the disk unless they say so.
class JournalWriter {
public:
    struct Options {
        /// What may wait for a slow disk: minutes of a session, or a large case at its beginning. Twice as much memory
        /// may be in use while it is written.
        BlockQueue::Limits queue{.blocks = 1024, .bytes = std::size_t{64} << 20};
        /// As long as a block of events, so that each is on the disk before the next one is full.
        std::chrono::milliseconds syncPeriod{500};
        /// Signs the recording, at each sync and at its end; null: unsealed.
        std::shared_ptr<const SigningKey> seal = {};
    };

    /// Makes the file, with its header on the disk. Fails with one sentence as createJournalFile does, or if the disk
    /// takes no more. `headerJson`: at most kMaxHeaderBytes.
    [[nodiscard]] static Expected<std::unique_ptr<JournalWriter>> create(const std::filesystem::path& path,
                                                                         std::string_view headerJson,
                                                                         const Options& options);
    [[nodiscard]] static Expected<std::unique_ptr<JournalWriter>> create(const std::filesystem::path& path,
                                                                         std::string_view headerJson);
    /// The same with any file; `name` stands for it in messages.
    [[nodiscard]] static Expected<std::unique_ptr<JournalWriter>> start(std::unique_ptr<JournalFile> file,
                                                                        std::string name, std::string_view headerJson,
                                                                        const Options& options);

    JournalWriter(const JournalWriter&) = delete;
    JournalWriter& operator=(const JournalWriter&) = delete;
    /// Without `close` before, all that waits is written, but no clean end: as after a crash.
    ~JournalWriter();

    /// Takes a block to be written behind those before it. False if it is lost: the queue is full (the file then says
    /// how many blocks are missing), or the recording has stopped. The payload has at most kMaxRawBytes, and at most
    /// kMaxStoredBytes when compressed.
    bool append(JournalBlock block);
    /// Waits until there is room: for large things at the beginning and end of a session.
    bool appendWhenRoom(JournalBlock block);

    /// Waits until all that was appended is on the disk.
    [[nodiscard]] Expected<void> flush();
    /// Writes the clean end and waits until it is on the disk. Call it once; nothing is taken afterwards. `tick`: the
    /// end of the session.
    [[nodiscard]] Expected<void> close(std::uint64_t tick);

    /// One sentence why the recording stopped. It does not begin again; the session can go on.
    [[nodiscard]] std::optional<Message> fault() const;
    /// Blocks that were appended and are not in the file, and will not be.
    [[nodiscard]] std::uint64_t lostBlocks() const;
    /// Size of the file.
    [[nodiscard]] std::uint64_t bytes() const;

private:
    using Clock = std::chrono::steady_clock;
    /// What the thread takes from the queue at once.
    struct Batch {
        std::vector<BlockQueue::Entry> entries;
        std::optional<LostFacts> lostBehind;
        std::uint64_t accepted = 0;  // accepted_ at that moment
        bool isSyncWanted = false;
        bool isLast = false;
        std::optional<std::uint64_t> closeTick;
        std::uint64_t failed = 0;  // blocks that were not written
    };

    JournalWriter(JournalAppender appender, const Options& options);

    bool accept(JournalBlock block);
    void end(std::optional<std::uint64_t> closeTick);
    void run();
    void waitForWork(std::unique_lock<std::mutex>& lock);
    [[nodiscard]] Batch takeBatch();
    void write(Batch& batch);
    void writeEntries(Batch& batch);
    void syncIfDue(bool isWanted);

    const Options options_;

    JournalAppender appender_;                  // of the thread alone, once it runs
    std::optional<Clock::time_point> syncDue_;  // of the thread alone

    mutable std::mutex mutex_;
    std::condition_variable wake_;  // the thread has something to do
    std::condition_variable done_;  // the thread has done something
    BlockQueue queue_;
    std::uint64_t accepted_ = 0;  // blocks that the queue took
    std::uint64_t synced_ = 0;    // of these, that are on the disk
    std::uint64_t lost_ = 0;
    std::uint64_t bytes_;
    bool isFlushWanted_ = false;
    bool isEnding_ = false;
    std::optional<std::uint64_t> closeTick_;
    std::optional<Message> fault_;

    std::jthread thread_;  // last member: it uses all others
};

}  // namespace tactooth
