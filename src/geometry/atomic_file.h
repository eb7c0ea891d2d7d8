// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/expected.h"

namespace tactooth {

/// A file that appears under its name only when it is complete. It is written under a temporary name in the same
/// folder and renamed by `commit`; without a commit nothing is left behind and an older file of that name stays.
class AtomicFile {
public:
    /// Opens the temporary file. Fails if the folder is missing or not writable, or if something other than a regular
    /// file has the name already (a device is never replaced). A symbolic link is followed.
    [[nodiscard]] static Expected<AtomicFile> create(const std::filesystem::path& path);

    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&&) = delete;
    ~AtomicFile();

    /// Appends. An error (a full disk) is kept and told by `commit`.
    void write(std::span<const std::byte> bytes);
    void write(std::string_view text);

    /// Gives the file its name; only then does it exist. To be called once.
    [[nodiscard]] Expected<void> commit();

private:
    AtomicFile(std::filesystem::path target, std::filesystem::path temporary, int descriptor);
    void flush();
    void discard();

    std::filesystem::path target_;
    std::filesystem::path temporary_;
    int descriptor_;
    int failure_ = 0;  ///< errno of the first write that failed
    std::vector<std::byte> buffer_;
};

/// A name in the same folder as `target` (a rename is atomic only inside one file system) that no other writer uses.
[[nodiscard]] std::filesystem::path temporaryNameBeside(const std::filesystem::path& target);

/// Writes a whole file: afterwards `path` holds `bytes`, or there is an error and `path` is as it was.
[[nodiscard]] Expected<void> writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
[[nodiscard]] Expected<void> writeFile(const std::filesystem::path& path, std::string_view text);

}  // namespace tactooth
