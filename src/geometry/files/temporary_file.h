// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace tactooth {

/// ".tactooth-0123456789abcdef.tmp" in `folder`. Drawn by chance: a process of the same number, here or on another
/// computer, has other names.
[[nodiscard]] std::filesystem::path randomNameIn(const std::filesystem::path& folder);
/// Whether randomNameIn gives such names.
[[nodiscard]] bool isRandomName(std::string_view name);

/// An open file that has no name yet, or one that tells that it is unfinished. It is locked (flock) while its writer
/// lives, which tells it from what a killed writer has left behind.
struct TemporaryFile {
    int descriptor = -1;
    std::filesystem::path name;  ///< empty: none yet
};

/// Opens a file without a name (O_TMPFILE): whatever ends the program, nothing is left of it. An errno, 0 for success;
/// not every file system can do it.
[[nodiscard]] int openUnnamed(const std::filesystem::path& folder, TemporaryFile& file);
/// Opens a file under a random name; whoever closes it removes it or gives it another name. An errno, 0 for success.
[[nodiscard]] int openNamed(const std::filesystem::path& folder, TemporaryFile& file);
/// The first of both that works, or the errno of the second.
[[nodiscard]] int openTemporary(const std::filesystem::path& folder, TemporaryFile& file);

/// Gives an unnamed file a name; EEXIST where it is taken.
[[nodiscard]] int linkUnnamed(int descriptor, const char* name);
/// "/proc/self/fd/7", by which an unnamed file is linked.
[[nodiscard]] std::string openFileName(int descriptor);

/// Locks a folder that carries a random name, as TemporaryFile is locked; the descriptor, -1 for failure.
[[nodiscard]] int lockFolder(const std::filesystem::path& folder);

/// Removes what killed writers of this user have left in `folder`: what has a random name and is locked by nobody.
void removeStale(const std::filesystem::path& folder);

/// Has the names in a folder outlive a power failure, as far as the file system allows.
void syncFolder(const std::filesystem::path& folder);

}  // namespace tactooth
