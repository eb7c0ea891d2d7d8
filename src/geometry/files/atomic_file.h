// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "geometry/util/expected.h"

namespace tactooth {

class FileTransaction;
class PendingFile;

/// A file that appears under its name only when it is complete and on the disk. It is written without a name, or, where
/// the file system cannot do that, under a random name in the same folder; `commit` gives it its name. Without a commit
/// nothing remains, and an older file of that name stays. A replaced file passes on its mode and owner. A symbolic link
/// to it stays one. Its other names (hard links) keep the old content.
class AtomicFile {
public:
    /// Fails if the folder is missing or not writable, or if something other than a regular file has the name already
    /// (a device is never replaced). If a FileTransaction has opened the path before, it uses that file.
    [[nodiscard]] static Expected<AtomicFile> create(const std::filesystem::path& path);

    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&&) = delete;
    ~AtomicFile();

    /// Appends. `commit` reports an error, such as a full disk.
    void write(std::span<const std::byte> bytes);
    void write(std::string_view text);

    /// Gives the file its name; only then does it exist. For a file of a transaction this waits for the commit of the
    /// transaction. Call it once.
    [[nodiscard]] Expected<void> commit();

private:
    AtomicFile(std::unique_ptr<PendingFile> file, FileTransaction* set);

    std::unique_ptr<PendingFile> file_;
    FileTransaction* set_;
};

/// Writes a whole file: afterwards `path` holds `bytes`, or there is an error and `path` is unchanged.
[[nodiscard]] Expected<void> writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
[[nodiscard]] Expected<void> writeFile(const std::filesystem::path& path, std::string_view text);

}  // namespace tactooth
