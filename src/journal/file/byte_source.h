// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "geometry/files/readable_file.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Bytes that can be read at any place. Any thread.
class ByteSource {
public:
    ByteSource() = default;
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;
    virtual ~ByteSource() = default;

    [[nodiscard]] virtual std::uint64_t size() const = 0;
    /// Reads from `offset` on until `bytes` is full or the source ends; gives the number of bytes.
    [[nodiscard]] virtual Expected<std::size_t> readAt(std::uint64_t offset, std::span<std::byte> bytes) const = 0;
};

[[nodiscard]] std::unique_ptr<ByteSource> sourceOf(ReadableFile file);
/// The bytes outlive the source.
[[nodiscard]] std::unique_ptr<ByteSource> sourceOf(std::span<const std::byte> bytes);

/// Reads forward through a source, a large piece at a time.
class ForwardReader {
public:
    static constexpr std::size_t kMost = std::size_t{64} << 10;  ///< bytes of one view

    explicit ForwardReader(const ByteSource& source) : source_(&source) {}

    /// `count` bytes from `offset` on, or fewer where the source ends; valid until the next call. At most kMost.
    [[nodiscard]] Expected<std::span<const std::byte>> view(std::uint64_t offset, std::size_t count);

private:
    const ByteSource* source_;
    std::unique_ptr<std::byte[]> buffer_;
    std::uint64_t begin_ = 0;  // of what is in the buffer
    std::size_t size_ = 0;
};

}  // namespace tactooth
