// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "journal/file/journal_file.h"

namespace tactooth::test {

/// A disk of memory that fails on demand. Shared by a test and the FakeJournalFile that a writer owns.
class FakeDisk {
public:
    static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    struct Faults {
        std::size_t capacity = kAll;     ///< bytes; then ENOSPC
        std::size_t bytesAtOnce = kAll;  ///< of one write
        int interruptEvery = 0;          ///< this many writes and syncs: EINTR
        int failingSync = 0;             ///< number of the sync that fails, from 1 on
        int syncFailure = 0;             ///< its errno
        int publishFailure = 0;          ///< errno
    };

    FakeDisk() = default;
    explicit FakeDisk(const Faults& faults) : faults_(faults) {}

    [[nodiscard]] JournalFile::Written write(std::span<const std::byte> bytes);
    [[nodiscard]] int sync();
    [[nodiscard]] int publish();

    /// While it is held, writes and syncs wait.
    void hold();
    void release();
    /// Waits until a write waits; false after half a minute.
    [[nodiscard]] bool waitUntilHeld();

    [[nodiscard]] std::vector<std::byte> bytes() const;
    /// As they were at the last sync: what a power failure leaves.
    [[nodiscard]] std::vector<std::byte> syncedBytes() const;
    [[nodiscard]] int syncs() const;
    /// Waits until there were so many syncs; false after half a minute.
    [[nodiscard]] bool waitForSyncs(int count);

private:
    [[nodiscard]] bool isInterrupted();

    Faults faults_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::byte> bytes_;
    std::size_t synced_ = 0;
    int calls_ = 0, syncs_ = 0;
    bool isHeld_ = false, isWaiting_ = false;
};

[[nodiscard]] std::unique_ptr<JournalFile> fileOn(const std::shared_ptr<FakeDisk>& disk);

}  // namespace tactooth::test
