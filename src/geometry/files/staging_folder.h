// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/util/expected.h"

namespace tactooth {

/// A folder of a random name that is filled before its content, or it itself, gets its name. Without that it goes again
/// with all that is in it, at the latest when somebody clears up after a writer that was killed (see removeStale).
class StagingFolder {
public:
    /// Inside `parent`, which exists.
    [[nodiscard]] static Expected<StagingFolder> make(const std::filesystem::path& parent);
    StagingFolder(StagingFolder&& other) noexcept;
    StagingFolder& operator=(StagingFolder&&) = delete;
    ~StagingFolder();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// The whole folder becomes `to`, which is not there or an empty folder. Fails with a few words of the system.
    [[nodiscard]] Expected<void> renameTo(const std::filesystem::path& to);
    /// All that is in it moves up into its parent, or nothing does.
    [[nodiscard]] Expected<void> moveUp();

private:
    StagingFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}

    std::filesystem::path path_;
    int lock_;  // descriptor
};

}  // namespace tactooth
