// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/codec/compression.h"

#include <zstd.h>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr int kLevel = 3;  // higher levels make columns of differences hardly smaller, and cost a multiple of the time

}  // namespace

struct Compressor::Context {
    struct Free {
        void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
    };
    std::unique_ptr<ZSTD_CCtx, Free> zstd{ZSTD_createCCtx()};
};

Compressor::Compressor() : context_(std::make_unique<Context>()) {}
Compressor::Compressor(Compressor&&) noexcept = default;
Compressor& Compressor::operator=(Compressor&&) noexcept = default;
Compressor::~Compressor() = default;

std::optional<std::vector<std::byte>> Compressor::compress(std::span<const std::byte> raw) {
    TACTOOTH_ASSERT(context_ != nullptr);
    if (raw.size() < 2 || context_->zstd == nullptr) return std::nullopt;
    // No more room than would be worth it: zstd gives up where its frame does not fit.
    std::vector<std::byte> frame(raw.size() - 1);
    const std::size_t size =
        ZSTD_compressCCtx(context_->zstd.get(), frame.data(), frame.size(), raw.data(), raw.size(), kLevel);
    if (ZSTD_isError(size) != 0) return std::nullopt;
    TACTOOTH_ASSERT(size <= frame.size());
    frame.resize(size);
    frame.shrink_to_fit();
    return frame;
}

std::optional<std::vector<std::byte>> decompress(std::span<const std::byte> frame, std::size_t rawBytes) {
    if (ZSTD_getFrameContentSize(frame.data(), frame.size()) != rawBytes) return std::nullopt;
    if (ZSTD_findFrameCompressedSize(frame.data(), frame.size()) != frame.size()) return std::nullopt;
    std::vector<std::byte> raw(rawBytes);
    const std::size_t size = ZSTD_decompress(raw.data(), raw.size(), frame.data(), frame.size());
    if (ZSTD_isError(size) != 0 || size != rawBytes) return std::nullopt;
    return raw;
}

}  // namespace tactooth
