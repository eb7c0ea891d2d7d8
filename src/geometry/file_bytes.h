// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "geometry/expected.h"

namespace tactooth {

/// The content of a file, in memory.
class FileBytes {
public:
    FileBytes(std::unique_ptr<std::byte[]> data, std::size_t size) : data_(std::move(data)), size_(size) {}

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::span<const std::byte> bytes() const { return {data_.get(), size_}; }

private:
    std::unique_ptr<std::byte[]> data_;
    std::size_t size_;
};

/// Reads the whole file at once. Fails with one sentence if `path` is missing, a folder or another thing that is not
/// a regular file, empty, not readable for this user, or larger than the memory.
[[nodiscard]] Expected<FileBytes> readFile(const std::filesystem::path& path);

/// `path` as a message shows it (UTF-8 as it came; control characters are written as '?').
[[nodiscard]] std::string shownName(const std::filesystem::path& path);

}  // namespace tactooth
