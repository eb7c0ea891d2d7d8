// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geometry/util/expected.h"

namespace tactooth {

/// Where the user's recordings are kept: $XDG_DATA_HOME/tactooth/recordings, else ~/.local/share/tactooth/recordings.
/// Empty if neither is known.
[[nodiscard]] std::filesystem::path defaultRecordingFolder();

/// The name of a finished recording without its ending: date, local time and tooth. What no file system takes is left
/// out of `title`.
[[nodiscard]] std::string recordingName(std::chrono::system_clock::time_point began, const std::string& title);

/// What a session left that nobody ended: a recording that was cut off by a crash, or a tooth that was saved when a
/// signal closed the program. As long as this object lives, no other window offers it.
class Leftover {
public:
    enum class Kind { Recording, Tooth };

    [[nodiscard]] Kind kind() const { return kind_; }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// When it was written last.
    [[nodiscard]] std::chrono::system_clock::time_point time() const { return time_; }

private:
    friend class RecordingFolder;
    class Lock;
    Leftover(Kind kind, std::filesystem::path file, std::shared_ptr<Lock> lock);

    Kind kind_;
    std::filesystem::path file_;
    std::chrono::system_clock::time_point time_;
    std::uint64_t order_;  // of the beginnings
    std::shared_ptr<Lock> lock_;
};

/// The folder where sessions are kept. While a session runs, its recording has a live name with the number of its
/// process and one that grows; when it ends, a name that people can read. Its orders do not trust the clock of the
/// computer, which may be set back. Any thread; several programs may use one folder.
class RecordingFolder {
public:
    static constexpr std::uint64_t kUsualBytes = 2'000'000'000;

    using Now = std::function<std::chrono::system_clock::time_point()>;

    /// `mostBytes`: of all recordings together. `now`: the clock, for tests.
    explicit RecordingFolder(std::filesystem::path folder, std::uint64_t mostBytes = kUsualBytes,
                             Now now = std::chrono::system_clock::now)
        : folder_(std::move(folder)), mostBytes_(mostBytes), now_(std::move(now)) {}

    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

    [[nodiscard]] std::chrono::system_clock::time_point now() const { return now_(); }

    /// A free name for a recording that begins now; makes the folder. It is never that of `before`, a recording that
    /// may be gone. Fails with one sentence if the folder cannot be made.
    [[nodiscard]] Expected<std::filesystem::path> liveName(const std::filesystem::path& before = {}) const {
        return freeName("live", ".ttsession", before);
    }
    /// The same for a tooth that is saved because a signal ends the program.
    [[nodiscard]] Expected<std::filesystem::path> autosaveName() const { return freeName("autosave", ".tactooth", {}); }
    /// Whether so many bytes can be written here now, by a trial; makes the folder. Waits for the disk.
    [[nodiscard]] bool hasRoomFor(std::uint64_t bytes) const;
    /// Gives a recording or tooth its final name, of `began` and `title`, and never that of another file. Returns it.
    /// It is the newest file of the folder then. Fails with one sentence; the file then keeps its name.
    [[nodiscard]] Expected<std::filesystem::path> keep(const std::filesystem::path& file,
                                                       std::chrono::system_clock::time_point began,
                                                       const std::string& title) const;
    /// Removes a file of this folder.
    void discard(const std::filesystem::path& file) const;

    /// Removes the oldest finished recordings until all files take no more than the cap: never one that is live, was
    /// left by a crash, or has a name that this class has not given.
    void tidy() const;
    /// The recordings that sessions have ended, newest first.
    [[nodiscard]] std::vector<std::filesystem::path> finished() const;
    /// What all recordings and teeth in the folder take.
    [[nodiscard]] std::uint64_t bytes() const;

    /// What was left by sessions that nobody ended; the one that began last comes first. No running program writes it,
    /// and no other window offers it.
    [[nodiscard]] std::vector<Leftover> leftovers() const;

private:
    void makeNewest(const std::filesystem::path& file) const;
    [[nodiscard]] Expected<std::filesystem::path> freeName(const std::string& kind, const std::string& ending,
                                                           const std::filesystem::path& before) const;

    std::filesystem::path folder_;
    std::uint64_t mostBytes_;
    Now now_;
};

}  // namespace tactooth
