// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/format/container_blocks.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>

#include "geometry/util/assert.h"
#include "geometry/util/byte_stream.h"

namespace tactooth {
namespace {

using Word = std::uint64_t;

std::vector<std::byte> payloadOf(std::initializer_list<Word> words) {
    ByteWriter out;
    for (const Word word : words) out.put(word);
    return out.take();
}

/// The words of a payload that holds just so many.
template <std::size_t kCount>
std::optional<std::array<Word, kCount>> wordsIn(std::span<const std::byte> payload) {
    if (payload.size() != kCount * sizeof(Word)) return std::nullopt;
    return ByteReader(payload).get<std::array<Word, kCount>>();
}

}  // namespace

JournalBlock indexBlock(std::uint64_t tick, std::span<const KeyframePlace> keyframes) {
    TACTOOTH_ASSERT(keyframes.size() <= kMaxBlocks);
    static_assert(sizeof(Word) + kMaxBlocks * 2 * sizeof(Word) <= kMaxRawBytes, "an index is one block");
    ByteWriter out;
    out.put(static_cast<Word>(keyframes.size()));
    for (const KeyframePlace& keyframe : keyframes) {
        out.put(keyframe.tick);
        out.put(keyframe.offset);
    }
    return {BlockType::Index, tick, 0, out.take()};
}

std::optional<std::vector<KeyframePlace>> parseIndex(std::span<const std::byte> payload) {
    ByteReader in(payload);
    const auto count = in.get<Word>();
    if (!in.ok() || count > kMaxBlocks || in.left() != count * 2 * sizeof(Word)) return std::nullopt;
    std::vector<KeyframePlace> keyframes;
    keyframes.reserve(count);
    for (Word i = 0; i < count; ++i) {
        const auto tick = in.get<Word>();
        keyframes.push_back({tick, in.get<Word>()});
    }
    TACTOOTH_ASSERT(in.ok() && in.left() == 0);
    return keyframes;
}

JournalBlock closedBlock(std::uint64_t tick, const ClosedFacts& facts) {
    return {BlockType::Closed, tick, 0, payloadOf({facts.indexOffset, facts.blocks, facts.lostBlocks})};
}

std::optional<ClosedFacts> parseClosed(std::span<const std::byte> payload) {
    const auto words = wordsIn<3>(payload);
    if (!words) return std::nullopt;
    return ClosedFacts{(*words)[0], (*words)[1], (*words)[2]};
}

JournalBlock recoveredBlock(std::uint64_t tick, const RecoveredFacts& facts) {
    return {BlockType::Recovered, tick, 0, payloadOf({facts.cutOffAt, facts.droppedBytes})};
}

std::optional<RecoveredFacts> parseRecovered(std::span<const std::byte> payload) {
    const auto words = wordsIn<2>(payload);
    if (!words) return std::nullopt;
    return RecoveredFacts{(*words)[0], (*words)[1]};
}

void LostFacts::add(const JournalBlock& block) {
    TACTOOTH_ASSERT(block.firstTick <= kMaxTick - block.ticks);
    const std::uint64_t end = block.firstTick + block.ticks;
    firstTick = blocks == 0 ? block.firstTick : std::min(firstTick, block.firstTick);
    endTick = blocks == 0 ? end : std::max(endTick, end);
    ++blocks;
    bytes += block.payload.size();
}

JournalBlock lostBlock(const LostFacts& facts) {
    TACTOOTH_ASSERT(facts.blocks > 0);
    TACTOOTH_ASSERT(facts.firstTick <= facts.endTick && facts.endTick <= kMaxTick);
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
    const auto ticks = static_cast<std::uint32_t>(std::min(facts.endTick - facts.firstTick, kMost));
    return {BlockType::Lost, facts.firstTick, ticks,
            payloadOf({facts.blocks, facts.bytes, facts.firstTick, facts.endTick})};
}

std::optional<LostFacts> parseLost(std::span<const std::byte> payload) {
    const auto words = wordsIn<4>(payload);
    if (!words) return std::nullopt;
    return LostFacts{(*words)[0], (*words)[1], (*words)[2], (*words)[3]};
}

JournalBlock trimmedBlock(const TrimmedFacts& facts) {
    TACTOOTH_ASSERT(facts.fromTick <= facts.toTick && facts.toTick <= kMaxTick);
    return {BlockType::Trimmed, facts.fromTick, 0, payloadOf({facts.fromTick, facts.toTick})};
}

std::optional<TrimmedFacts> parseTrimmed(std::span<const std::byte> payload) {
    const auto words = wordsIn<2>(payload);
    if (!words) return std::nullopt;
    return TrimmedFacts{(*words)[0], (*words)[1]};
}

}  // namespace tactooth
