// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>

#include "geometry/util/expected.h"
#include "session/model/task.h"

namespace tactooth {

/// Is called with the share of the work that is done, 0..1, on any thread. False: the work is to be given up.
using GoesOn = std::function<bool(double share)>;

/// Writes files in the background, one after another, in the order in which they were given. All functions are for one
/// thread.
class FileWriter {
public:
    /// Makes and writes one file, on a thread of its own. Returns false if it was given up: then nothing has changed on
    /// the disk. Fails with one sentence.
    using Write = std::function<Expected<bool>(const GoesOn& goesOn)>;
    /// Is called by `poll` or `finish` with what `Write` has returned.
    using Done = std::function<void(const Expected<bool>& written)>;

    explicit FileWriter(const TaskExecutor& executor = runInThread) : task_(executor) {}
    /// Waits until all files are written; calls no `Done`.
    ~FileWriter();
    FileWriter(const FileWriter&) = delete;
    FileWriter& operator=(const FileWriter&) = delete;

    void write(Write write, Done done);
    /// From `write` until `Done` was called for the last file.
    [[nodiscard]] bool isBusy() const { return !jobs_.empty(); }
    /// The share of the present file that is done, 0..1.
    [[nodiscard]] double share() const;
    /// Gives up the present file and those that wait. A file that is written already stays.
    void cancel();
    /// Takes over what is ready, and begins with the next file. Call it often; it returns at once.
    void poll();
    /// Waits until all files are written.
    void finish();
    /// How many files could not be written or were given up, so far.
    [[nodiscard]] std::size_t unwritten() const { return unwritten_; }

private:
    struct Control {
        std::atomic<double> share{0};
        std::atomic<bool> stops{false};
    };
    struct Job {
        Write write;
        Done done;
        std::shared_ptr<Control> control;
    };
    void startFirst();

    std::deque<Job> jobs_;  // the first one is being written
    std::size_t unwritten_ = 0;
    Task<bool> task_;
};

/// Writes a whole file piece by piece, as writeFile does. False: it was given up, and `path` is unchanged.
[[nodiscard]] Expected<bool> writeInPieces(const std::filesystem::path& path, std::span<const std::byte> bytes,
                                           const GoesOn& goesOn);

}  // namespace tactooth
