// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

namespace tactooth {

/// Where a name leads: two that are equal lead to one file, whatever way they are written in: through links, "." or
/// "..", or as two names of one file. The file need not exist.
struct FileIdentity {
    std::filesystem::path canonicalPath;  ///< absolute, without links
    std::uint64_t device = 0;             ///< both 0: there is no such file
    std::uint64_t number = 0;

    [[nodiscard]] static FileIdentity of(const std::filesystem::path& path);
    [[nodiscard]] bool operator==(const FileIdentity& other) const {
        return canonicalPath == other.canonicalPath ||
               (number != 0 && number == other.number && device == other.device);
    }
    /// Whether this lies in a folder, or below it.
    [[nodiscard]] bool isInside(const FileIdentity& folder) const;
};

/// Where writing to `path` leads: symbolic links are followed, also one to a file that is not there yet.
[[nodiscard]] std::filesystem::path linksFollowed(const std::filesystem::path& path);

}  // namespace tactooth
