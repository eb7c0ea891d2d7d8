// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

namespace tactooth {

/// The file that a path leads to. Two equal identities are one file, however the paths are written: through links, "."
/// or "..", or as two names of one file. The file need not exist.
struct FileIdentity {
    std::filesystem::path canonicalPath;  ///< absolute, without links
    std::uint64_t device = 0;             ///< both 0: there is no such file
    std::uint64_t number = 0;

    [[nodiscard]] static FileIdentity of(const std::filesystem::path& path);
    [[nodiscard]] bool operator==(const FileIdentity& other) const {
        return canonicalPath == other.canonicalPath ||
               (number != 0 && number == other.number && device == other.device);
    }
    /// Whether this is in a folder, or below it.
    [[nodiscard]] bool isInside(const FileIdentity& folder) const;
};

/// The file that writing to `path` would change: symbolic links are followed, also a link to a missing file.
[[nodiscard]] std::filesystem::path linksFollowed(const std::filesystem::path& path);

}  // namespace tactooth
