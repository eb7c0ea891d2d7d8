// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "geometry/util/expected.h"

namespace tactooth {

/// A regular file that is open for reading at any place.
class ReadableFile {
public:
    /// Fails with one sentence if `path` is missing, not a regular file, or not readable for this user.
    [[nodiscard]] static Expected<ReadableFile> open(const std::filesystem::path& path);

    ReadableFile(ReadableFile&& other) noexcept;
    ReadableFile& operator=(ReadableFile&&) = delete;
    ~ReadableFile();

    /// Bytes that it had when it was opened.
    [[nodiscard]] std::uint64_t size() const { return size_; }

    /// Reads from the byte `offset` on until `bytes` is full or the file ends; gives the number of bytes. Any thread.
    [[nodiscard]] Expected<std::size_t> readAt(std::uint64_t offset, std::span<std::byte> bytes) const;

private:
    ReadableFile(int descriptor, std::string name) : descriptor_(descriptor), name_(std::move(name)) {}

    int descriptor_;
    std::uint64_t size_ = 0;
    std::string name_;  // for messages
};

}  // namespace tactooth
