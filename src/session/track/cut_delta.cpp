// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/track/cut_delta.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "geometry/util/assert.h"

// A record: the brick, the number of words that differ, their places, and the bits that differ in each.

namespace tactooth {
namespace {

using Word = std::uint32_t;

constexpr std::size_t kFieldWords = 8 * std::size_t{kBrickNodes};
constexpr std::size_t kAllWords = kFieldWords + 1;  // and CutField::isCut
static_assert(std::is_trivially_copyable_v<CutField>);
static_assert(sizeof(CutField) == kAllWords * sizeof(Word));
static_assert(kAllWords <= std::numeric_limits<std::uint16_t>::max());

constexpr std::size_t kLossWords = sizeof(ToothLoss) / sizeof(Word);
static_assert(std::is_trivially_copyable_v<ToothLoss>);
static_assert(sizeof(ToothLoss) == (2 * kMaxMaterials + 1) * sizeof(double) + 2 * sizeof(std::size_t));

constexpr BrickKey kLossKey{std::numeric_limits<int>::min(), 0, 0};  // no brick

using FieldWords = std::array<Word, kAllWords>;
using LossWords = std::array<Word, kLossWords>;

FieldWords wordsOf(const CutField& field) {
    FieldWords words{};
    std::memcpy(words.data(), &field, kFieldWords * sizeof(Word));
    words.back() = field.isCut ? 1 : 0;  // the bytes behind it are no part of the value
    return words;
}

LossWords wordsOf(const ToothLoss& loss) {
    LossWords words;
    std::memcpy(words.data(), &loss, sizeof(loss));
    return words;
}

template <class Value>
void put(std::vector<std::byte>& bytes, const Value* values, std::size_t count) {
    const auto* const first = reinterpret_cast<const std::byte*>(values);
    bytes.insert(bytes.end(), first, first + count * sizeof(Value));
}

/// Nothing is added where nothing differs.
template <std::size_t kCount>
void addRecord(std::vector<std::byte>& bytes, const BrickKey& key, const std::array<Word, kCount>& before,
               const std::array<Word, kCount>& after) {
    std::array<std::uint16_t, kCount> places;
    std::array<Word, kCount> bits;
    std::size_t count = 0;
    for (std::size_t i = 0; i < kCount; ++i) {
        if (before[i] == after[i]) continue;
        places[count] = static_cast<std::uint16_t>(i);
        bits[count++] = before[i] ^ after[i];
    }
    if (count == 0) return;
    const auto size = static_cast<std::uint16_t>(count);
    put(bytes, &key, 1);
    put(bytes, &size, 1);
    put(bytes, places.data(), count);
    put(bytes, bits.data(), count);
}

/// Reads the records of a difference.
class Records {
public:
    explicit Records(std::span<const std::byte> bytes) : left_(bytes) {}

    [[nodiscard]] bool next() {
        if (left_.empty()) return false;
        key_ = get<BrickKey>();
        count_ = get<std::uint16_t>();
        places_ = take(count_ * sizeof(std::uint16_t));
        bits_ = take(count_ * sizeof(Word));
        return true;
    }
    [[nodiscard]] const BrickKey& key() const { return key_; }

    /// Calls `visit(place, bits)` for each word of the record.
    template <class Visit>
    void forEachWord(const Visit& visit) const {
        for (std::size_t i = 0; i < count_; ++i) {
            std::uint16_t place = 0;
            Word bits = 0;
            std::memcpy(&place, places_.data() + i * sizeof(place), sizeof(place));
            std::memcpy(&bits, bits_.data() + i * sizeof(bits), sizeof(bits));
            visit(place, bits);
        }
    }

private:
    std::span<const std::byte> take(std::size_t size) {
        TACTOOTH_ASSERT(size <= left_.size());
        const std::span<const std::byte> taken = left_.first(size);
        left_ = left_.subspan(size);
        return taken;
    }
    template <class Value>
    Value get() {
        Value value;
        std::memcpy(&value, take(sizeof(value)).data(), sizeof(value));
        return value;
    }

    std::span<const std::byte> left_, places_, bits_;
    BrickKey key_{};
    std::size_t count_ = 0;
};

/// Flips bits of one word of a value in place: a field is 16 KB, and a step changes little of it.
void flipBits(void* value, std::size_t place, Word bits) {
    std::byte* const at = static_cast<std::byte*>(value) + place * sizeof(Word);
    Word word = 0;
    std::memcpy(&word, at, sizeof(word));
    word ^= bits;
    std::memcpy(at, &word, sizeof(word));
}

}  // namespace

void CutDelta::add(const BrickKey& key, const CutField& before, const CutField& after) {
    TACTOOTH_ASSERT(key.isInRange());
    addRecord(bytes_, key, wordsOf(before), wordsOf(after));
}

void CutDelta::add(const ToothLoss& before, const ToothLoss& after) {
    addRecord(bytes_, kLossKey, wordsOf(before), wordsOf(after));
}

void applyDelta(std::span<const std::byte> delta, const std::function<CutField&(const BrickKey&)>& fieldOf,
                ToothLoss& loss) {
    for (Records records(delta); records.next();) {
        if (records.key() == kLossKey) {
            records.forEachWord([&loss](std::size_t place, Word bits) {
                TACTOOTH_ASSERT(place < kLossWords);
                flipBits(&loss, place, bits);
            });
            continue;
        }
        CutField& field = fieldOf(records.key());
        records.forEachWord([&field](std::size_t place, Word bits) {
            TACTOOTH_ASSERT(place < kAllWords);
            if (place < kFieldWords) {
                flipBits(&field, place, bits);
            } else {
                field.isCut = field.isCut != (bits != 0);
            }
        });
    }
}

}  // namespace tactooth
