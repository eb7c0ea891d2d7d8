// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace tactooth {

/// ".tactooth-0123456789abcdef.tmp" in `folder`. The digits are random: a process with the same number, on this or
/// another computer, gets other names.
[[nodiscard]] std::filesystem::path randomNameIn(const std::filesystem::path& folder);
/// Whether a name has the form of randomNameIn.
[[nodiscard]] bool isRandomName(std::string_view name);

/// An open file without a name, or with a name that marks it as unfinished. It is locked (flock) while its writer
/// lives, which distinguishes it from the remains of a killed writer.
struct TemporaryFile {
    int descriptor = -1;
    std::filesystem::path name;  ///< empty: none yet
};

/// Opens a file without a name (O_TMPFILE): whatever ends the program, nothing remains. Returns an errno, 0 for
/// success; not every file system supports it.
[[nodiscard]] int openUnnamed(const std::filesystem::path& folder, TemporaryFile& file);
/// Opens a file under a random name; the caller removes or renames it before closing it. Returns an errno, 0 for
/// success.
[[nodiscard]] int openNamed(const std::filesystem::path& folder, TemporaryFile& file);
/// The first of both that works, or the errno of the second.
[[nodiscard]] int openTemporary(const std::filesystem::path& folder, TemporaryFile& file);
/// The same for a secret: from its first moment no other user can open it.
[[nodiscard]] int openPrivateTemporary(const std::filesystem::path& folder, TemporaryFile& file);

/// Writes all bytes to an open file. Returns an errno, 0 for success.
[[nodiscard]] int writeAll(int descriptor, std::span<const std::byte> bytes);

/// Gives an unnamed file a name; EEXIST if it is taken.
[[nodiscard]] int linkUnnamed(int descriptor, const char* name);
/// "/proc/self/fd/7", the path to link an unnamed file from.
[[nodiscard]] std::string openFileName(int descriptor);

/// Locks a folder with a random name, like a TemporaryFile. Returns the descriptor, -1 for failure.
[[nodiscard]] int lockFolder(const std::filesystem::path& folder);

/// Removes the remains of killed writers of this user in `folder`: what has a random name and no lock.
void removeStale(const std::filesystem::path& folder);

/// Makes the names in a folder survive a power failure, as far as the file system supports it.
void syncFolder(const std::filesystem::path& folder);

}  // namespace tactooth
