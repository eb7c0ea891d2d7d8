// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "geometry/util/assert.h"
#include "geometry/util/byte_text.h"
#include "geometry/util/expected.h"
#include "geometry/util/large_pages.h"

namespace tactooth {

/// The content of a file, in memory.
class FileBytes {
public:
    /// `data` holds `size` bytes and comes from allocateOnLargePages.
    FileBytes(std::byte* data, std::size_t size) : data_(data), size_(size) {}

    /// Keeps the first `size` bytes only.
    void shorten(std::size_t size) {
        TACTOOTH_ASSERT(size <= size_);
        size_ = size;
    }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::span<const std::byte> bytes() const { return {data_.get(), size_}; }
    [[nodiscard]] std::string_view text() const { return asText(bytes()); }

private:
    struct Free {
        void operator()(std::byte* data) const { freeLargePages(data); }
    };
    std::unique_ptr<std::byte[], Free> data_;
    std::size_t size_;
};

/// Largest file that is read: ten million triangles take a quarter of it. A larger file is a mistake.
inline constexpr std::size_t kMaxFileBytes = std::size_t{2} << 30;

/// Reads the whole file at once. Fails with one sentence if `path` is missing, not a regular file, empty, not readable
/// for this user, larger than `most` bytes (then no memory is taken), or larger than the memory.
[[nodiscard]] Expected<FileBytes> readFile(const std::filesystem::path& path, std::size_t most = kMaxFileBytes);

/// `path` in a form for a message or a list: see displayText.
[[nodiscard]] std::string displayName(const std::filesystem::path& path);

/// The last part of `path` as displayName shows it, for files that are passed on. The folders above it may contain the
/// name of a person.
[[nodiscard]] std::string displayFileName(const std::filesystem::path& path);

}  // namespace tactooth
