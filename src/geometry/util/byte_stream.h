// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "geometry/util/assert.h"
#include "geometry/util/fnv1a.h"

namespace tactooth {

static_assert(std::endian::native == std::endian::little, "files are little-endian, and written as memory is");

/// Detects damage of a file (FNV-1a, 64 bit).
[[nodiscard]] inline std::uint64_t checksum(std::span<const std::byte> bytes) {
    return Fnv1a().addBytes(bytes).value();
}

/// Collects the bytes of a file.
class ByteWriter {
public:
    template <class Value>
    void put(const Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        const std::size_t at = bytes_.size();
        bytes_.resize(at + sizeof(Value));
        std::memcpy(bytes_.data() + at, &value, sizeof(Value));
    }
    template <class Value>
    void putAll(std::span<const Value> values) {
        const std::span<const std::byte> raw = std::as_bytes(values);
        bytes_.insert(bytes_.end(), raw.begin(), raw.end());
    }
    void putText(std::string_view text) {
        TACTOOTH_ASSERT(text.size() <= std::numeric_limits<std::uint32_t>::max());
        put(static_cast<std::uint32_t>(text.size()));
        putAll(std::span(text.data(), text.size()));
    }

    [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }
    [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
};

/// Reads what a ByteWriter wrote. The bytes may be damaged or hostile. After the first read beyond the end every read
/// returns zeros, and `ok` stays false.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    template <class Value>
    Value get() {
        static_assert(std::is_trivially_copyable_v<Value>);
        Value value{};
        const std::span<const std::byte> raw = getBytes(sizeof(Value));
        if (!raw.empty()) std::memcpy(&value, raw.data(), sizeof(Value));
        return value;
    }
    /// Returns `count` values, or none if the bytes hold fewer.
    template <class Value>
    std::vector<Value> getAll(std::uint64_t count) {
        if (count > left() / sizeof(Value)) ok_ = false;
        if (!ok_ || count == 0) return {};
        std::vector<Value> values(count);
        std::memcpy(values.data(), getBytes(count * sizeof(Value)).data(), count * sizeof(Value));
        return values;
    }
    std::string getText() {
        const std::vector<char> text = getAll<char>(get<std::uint32_t>());
        return {text.begin(), text.end()};
    }
    std::span<const std::byte> getBytes(std::uint64_t count) {
        if (count > left()) ok_ = false;
        if (!ok_) return {};
        const auto part = bytes_.subspan(at_, count);
        at_ += count;
        TACTOOTH_ASSERT(at_ <= bytes_.size());
        return part;
    }

    /// Marks the bytes as damaged: what was read is not what its format allows.
    void fail() { ok_ = false; }

    [[nodiscard]] bool ok() const { return ok_; }
    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
    bool ok_ = true;
};

}  // namespace tactooth
