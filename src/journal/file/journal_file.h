// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

#include "geometry/util/expected.h"

namespace tactooth {

/// A file that a recording is appended to. For one thread.
class JournalFile {
public:
    struct Written {
        std::size_t bytes = 0;
        int failure = 0;  ///< errno; 0: none. After EINTR one may try again.
    };

    JournalFile() = default;
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;
    virtual ~JournalFile() = default;

    /// Appends the beginning of `bytes`, and says how much of it, as write(2) does.
    [[nodiscard]] virtual Written write(std::span<const std::byte> bytes) = 0;
    /// Brings what was written to the disk, as fdatasync(2) does. Returns an errno, 0 for success; ENOENT if the file
    /// has been deleted since.
    [[nodiscard]] virtual int sync() = 0;
    /// Gives the file its name, once. Returns an errno, 0 for success; EEXIST if there is a file of that name.
    [[nodiscard]] virtual int publish() = 0;
};

/// What happens to a file that has the name of a new recording.
enum class ExistingFile {
    Kept,             ///< it stays, and there is no recording
    ReplacedIfOurOwn  ///< a recording or an empty file is replaced; all else stays, and there is no recording
};

/// A new file on the disk. It has no name before `publish` (geometry/files/temporary_file.h), so nobody finds a
/// recording without a head. While it is open it is locked. Fails with one sentence if the folder is missing or not
/// writable, or if something has the name already that is not to be replaced. A recording that is still written stays
/// in any case. An old file keeps its name until `publish`.
[[nodiscard]] Expected<std::unique_ptr<JournalFile>> createJournalFile(const std::filesystem::path& path,
                                                                       ExistingFile existing = ExistingFile::Kept);

/// Whether a running program writes this recording. False also if there is no such file.
[[nodiscard]] bool isBeingRecorded(const std::filesystem::path& path);

}  // namespace tactooth
