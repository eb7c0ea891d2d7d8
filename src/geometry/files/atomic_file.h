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

/// A file that appears under its name only when it is complete and on the disk. It is written without a name, or where
/// the file system cannot do that under a random one in the same folder; `commit` names it. Without a commit nothing is
/// left behind and an older file of that name stays. What is replaced hands on its mode and owner; a symbolic link to
/// it stays one; other names of it (hard links) keep what they had.
class AtomicFile {
public:
    /// Fails if the folder is missing or not writable, or if something other than a regular file has the name already
    /// (a device is never replaced). A file that a FileTransaction has opened beforehand is that one.
    [[nodiscard]] static Expected<AtomicFile> create(const std::filesystem::path& path);

    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&&) = delete;
    ~AtomicFile();

    /// Appends. An error (a full disk) is kept and told by `commit`.
    void write(std::span<const std::byte> bytes);
    void write(std::string_view text);

    /// Gives the file its name; only then does it exist. Of a file of a set, that waits for the commit of the set. To
    /// be called once.
    [[nodiscard]] Expected<void> commit();

private:
    AtomicFile(std::unique_ptr<PendingFile> file, FileTransaction* set);

    std::unique_ptr<PendingFile> file_;
    FileTransaction* set_;
};

/// Writes a whole file: afterwards `path` holds `bytes`, or there is an error and `path` is as it was.
[[nodiscard]] Expected<void> writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
[[nodiscard]] Expected<void> writeFile(const std::filesystem::path& path, std::string_view text);

}  // namespace tactooth
