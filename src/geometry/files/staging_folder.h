// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/util/expected.h"

namespace tactooth {

/// A folder with a random name that is filled before it, or its content, gets its final name. Otherwise it is removed
/// with its content; if the writer was killed, the next call of removeStale removes it.
class StagingFolder {
public:
    /// Inside `parent`, which exists.
    [[nodiscard]] static Expected<StagingFolder> make(const std::filesystem::path& parent);
    StagingFolder(StagingFolder&& other) noexcept;
    StagingFolder& operator=(StagingFolder&&) = delete;
    ~StagingFolder();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Renames the whole folder to `to`, which is missing or an empty folder. Fails with a few words of the system.
    [[nodiscard]] Expected<void> renameTo(const std::filesystem::path& to);
    /// Moves the whole content into the parent folder, or nothing.
    [[nodiscard]] Expected<void> moveUp();

private:
    StagingFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}

    std::filesystem::path path_;
    int lock_;  // descriptor
};

}  // namespace tactooth
