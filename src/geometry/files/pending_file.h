// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "geometry/files/rename_together.h"
#include "geometry/files/temporary_file.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// The file behind an AtomicFile: written, finished, and then renamed, alone or together with others.
class PendingFile {
public:
    /// Fails if the folder is missing or not writable, or if something other than a regular file has the name already.
    [[nodiscard]] static Expected<std::unique_ptr<PendingFile>> open(const std::filesystem::path& path);

    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;
    ~PendingFile();

    /// The path that was given to `open`.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    void write(std::span<const std::byte> bytes);

    /// Writes all to the disk, and copies mode and owner of the file that will be replaced.
    [[nodiscard]] Expected<void> finish();

    /// The rename of the finished file.
    [[nodiscard]] PendingRename naming() const;
    /// Call it after the rename.
    void close();
    [[nodiscard]] Unexpected cannotBeNamed(int reason) const;

private:
    PendingFile(std::filesystem::path path, std::filesystem::path target, TemporaryFile file);
    void flush();
    [[nodiscard]] int copyModeFrom() const;

    std::filesystem::path path_;
    std::filesystem::path target_;  // the path with its links followed
    TemporaryFile file_;
    int failure_ = 0;  // errno of the first write that failed
    std::vector<std::byte> buffer_;
};

}  // namespace tactooth
