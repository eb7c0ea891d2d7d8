// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tactooth {

/// Compresses pieces of bytes, each as one zstd frame (RFC 8878) that states its size. For one thread.
class Compressor {
public:
    Compressor();
    Compressor(Compressor&&) noexcept;
    Compressor& operator=(Compressor&&) noexcept;
    ~Compressor();

    /// Gives the frame, or nothing if it is not smaller than `raw`.
    [[nodiscard]] std::optional<std::vector<std::byte>> compress(std::span<const std::byte> raw);

private:
    struct Context;
    std::unique_ptr<Context> context_;
};

/// Unpacks one zstd frame of exactly `rawBytes` bytes, and takes no more memory than that. Gives nothing if it is
/// damaged, has another size, or something follows it.
[[nodiscard]] std::optional<std::vector<std::byte>> decompress(std::span<const std::byte> frame, std::size_t rawBytes);

}  // namespace tactooth
