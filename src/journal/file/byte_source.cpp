// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/byte_source.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

class FileSource final : public ByteSource {
public:
    explicit FileSource(ReadableFile file) : file_(std::move(file)) {}
    std::uint64_t size() const override { return file_.size(); }
    Expected<std::size_t> readAt(std::uint64_t offset, std::span<std::byte> bytes) const override {
        return file_.readAt(offset, bytes);
    }

private:
    ReadableFile file_;
};

class MemorySource final : public ByteSource {
public:
    explicit MemorySource(std::span<const std::byte> bytes) : bytes_(bytes) {}
    std::uint64_t size() const override { return bytes_.size(); }
    Expected<std::size_t> readAt(std::uint64_t offset, std::span<std::byte> bytes) const override {
        if (offset >= bytes_.size()) return std::size_t{0};
        const std::size_t count = std::min<std::size_t>(bytes.size(), bytes_.size() - offset);
        std::ranges::copy(bytes_.subspan(offset, count), bytes.begin());
        return count;
    }

private:
    std::span<const std::byte> bytes_;
};

}  // namespace

std::unique_ptr<ByteSource> sourceOf(ReadableFile file) { return std::make_unique<FileSource>(std::move(file)); }
std::unique_ptr<ByteSource> sourceOf(std::span<const std::byte> bytes) { return std::make_unique<MemorySource>(bytes); }

Expected<std::span<const std::byte>> ForwardReader::view(std::uint64_t offset, std::size_t count) {
    TACTOOTH_ASSERT(count <= kMost);
    if (buffer_ == nullptr) buffer_ = std::make_unique_for_overwrite<std::byte[]>(kMost);
    if (offset < begin_ || offset + count > begin_ + size_) {
        const Expected<std::size_t> size = source_->readAt(offset, {buffer_.get(), kMost});
        if (!size) return Unexpected{size.error()};
        begin_ = offset;
        size_ = *size;
    }
    const std::size_t at = offset - begin_;
    TACTOOTH_ASSERT(at <= size_);
    return std::span<const std::byte>(buffer_.get() + at, std::min(count, size_ - at));
}

}  // namespace tactooth
