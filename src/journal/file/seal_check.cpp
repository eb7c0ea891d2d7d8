// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/seal_check.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "geometry/util/assert.h"
#include "journal/codec/crc32c.h"
#include "journal/file/byte_source.h"
#include "journal/file/messages.h"
#include "journal/format/block_encoder.h"
#include "journal/format/container_blocks.h"
#include "journal/format/signature_block.h"

namespace tactooth {
namespace {

using Bytes = std::span<const std::byte>;
using State = SealCheck::State;

/// A Closed block is never compressed and has three words.
constexpr std::size_t kClosedBytes = kBlockHeaderBytes + 3 * sizeof(std::uint64_t);

/// Goes through a recording, from signature to signature.
class SealWalk {
public:
    SealWalk(const JournalReader& journal, const PublicKey& key)
        : journal_(journal), key_(key), in_(journal.source()) {}

    Expected<SealCheck> run();

private:
    [[nodiscard]] Expected<bool> isValid(const BlockPlace& block);
    [[nodiscard]] Expected<std::vector<std::byte>> bytesAt(std::uint64_t offset, std::size_t count) const;
    [[nodiscard]] Expected<void> digestUntil(std::uint64_t end);
    [[nodiscard]] Expected<std::uint64_t> lostBlocks() const;
    [[nodiscard]] Expected<std::vector<std::byte>> onlyEnd() const;
    [[nodiscard]] Expected<void> checkEnd();
    [[nodiscard]] Expected<bool> isTorn() const;
    void setChanged(std::uint64_t from, std::uint64_t before);

    const JournalReader& journal_;
    const PublicKey& key_;
    ForwardReader in_;
    Digester digester_;
    std::uint64_t digested_ = 0;  // bytes
    SealCheck check_;
    const BlockPlace* last_ = nullptr;  // signature, valid
    SealPoint point_ = SealPoint::Running;
};

void SealWalk::setChanged(std::uint64_t from, std::uint64_t before) {
    TACTOOTH_ASSERT(from < before);
    check_.state = State::Changed;
    check_.changedFrom = from;
    check_.changedBefore = before;
}

Expected<std::vector<std::byte>> SealWalk::bytesAt(std::uint64_t offset, std::size_t count) const {
    std::vector<std::byte> bytes(count);
    const Expected<std::size_t> read = journal_.source().readAt(offset, bytes);
    if (!read) return Unexpected{read.error()};
    bytes.resize(*read);
    return bytes;
}

Expected<void> SealWalk::digestUntil(std::uint64_t end) {
    while (digested_ < end) {
        const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(ForwardReader::kMost, end - digested_));
        const Expected<Bytes> piece = in_.view(digested_, wanted);
        if (!piece) return Unexpected{piece.error()};
        if (piece->size() < wanted) return unexpected(msg::kJournalBlockUnreadable, journal_.name(), digested_);
        digester_.add(*piece);
        digested_ += wanted;
    }
    return {};
}

Expected<bool> SealWalk::isValid(const BlockPlace& block) {
    if (!hasSignatureForm(block.header) || point_ == SealPoint::End) return false;
    if (const auto done = digestUntil(block.offset); !done) return Unexpected{done.error()};
    const Expected<std::vector<std::byte>> payload = journal_.storedPayload(block);
    if (!payload) return Unexpected{payload.error()};
    const std::optional<StoredSignature> stored = parseSignature(*payload);
    if (!stored) return false;
    const SealPlace place{block.offset, block.header.firstTick, stored->point};
    if (!isSignedBy(key_, signedMessage(place, digester_.digest()), stored->signature)) return false;
    point_ = stored->point;
    return true;
}

Expected<SealCheck> SealWalk::run() {
    for (const BlockPlace& block : journal_.blocks()) {
        if (block.header.type != BlockType::Signature) continue;
        const Expected<bool> valid = isValid(block);
        if (!valid) return Unexpected{valid.error()};
        if (!*valid) {
            setChanged(check_.signedBytes, block.end());
            return check_;
        }
        ++check_.signatures;
        check_.signedBytes = block.end();
        last_ = &block;
    }
    if (const auto done = checkEnd(); !done) return Unexpected{done.error()};
    return check_;
}

/// As the Lost blocks say.
Expected<std::uint64_t> SealWalk::lostBlocks() const {
    std::uint64_t sum = 0;
    for (const BlockPlace& block : journal_.blocks()) {
        if (block.header.type != BlockType::Lost) continue;
        const Expected<std::vector<std::byte>> payload = journal_.payload(block);
        if (!payload) return Unexpected{payload.error()};
        if (const auto lost = parseLost(*payload)) sum += lost->blocks;
    }
    return sum;
}

/// The one Closed block that may follow the last signature; nothing if it does not sign an end.
Expected<std::vector<std::byte>> SealWalk::onlyEnd() const {
    const std::span<const BlockPlace> blocks = journal_.blocks();
    const auto index = static_cast<std::size_t>(last_ - blocks.data());
    if (point_ != SealPoint::End || index == 0 || blocks[index - 1].header.type != BlockType::Index) {
        return std::vector<std::byte>();
    }
    const Expected<std::uint64_t> lost = lostBlocks();
    if (!lost) return Unexpected{lost.error()};
    BlockEncoder encoder(last_->header.crc);
    auto end = encoder.encode(closedBlock(last_->header.firstTick, {blocks[index - 1].offset, index + 1, *lost}));
    TACTOOTH_ASSERT(end && end->size() == kClosedBytes);
    return std::move(*end);
}

/// Whether what follows the whole blocks is the beginning of a block that never got whole, as a crash leaves it.
Expected<bool> SealWalk::isTorn() const {
    const std::uint64_t at = journal_.scan().end, rest = journal_.bytes() - at;
    const auto tail = bytesAt(at, static_cast<std::size_t>(std::min<std::uint64_t>(rest, kBlockHeaderBytes)));
    if (!tail) return Unexpected{tail.error()};
    if (tail->size() < kBlockHeaderBytes) {
        // Any beginning of a header; the CRC of the block before stands in it.
        const auto known = blockHeaderBytes({.previousCrc = journal_.scan().lastCrc()});
        const std::size_t magic = std::min(tail->size(), sizeof kBlockMagic);
        return std::equal(tail->begin(), tail->begin() + static_cast<std::ptrdiff_t>(magic), known.begin());
    }
    const auto header = parseBlockHeader(Bytes(*tail).first<kBlockHeaderBytes>());
    if (!header || header->previousCrc != journal_.scan().lastCrc()) return false;
    if (rest >= kBlockHeaderBytes + header->storedBytes) return false;  // it is all there, and wrong
    // A file that has its end was not cut off.
    const auto closing = bytesAt(journal_.bytes() - std::min<std::uint64_t>(kClosedBytes, rest), kClosedBytes);
    if (!closing) return Unexpected{closing.error()};
    if (closing->size() < kClosedBytes) return true;
    const auto head = Bytes(*closing).first<kBlockHeaderBytes>();
    const auto end = parseBlockHeader(head);
    const bool isEnd = end && end->type == BlockType::Closed &&
                       crc32c(Bytes(*closing).subspan(kBlockHeaderBytes), blockHeaderCrc(head)) == end->crc;
    return !isEnd;
}

/// Judges what stands behind the last signature.
Expected<void> SealWalk::checkEnd() {
    const std::uint64_t size = journal_.bytes();
    if (last_ != nullptr && point_ == SealPoint::End) {
        const auto wanted = onlyEnd();
        if (!wanted) return Unexpected{wanted.error()};
        const auto found =
            bytesAt(check_.signedBytes,
                    static_cast<std::size_t>(std::min<std::uint64_t>(size - check_.signedBytes, kClosedBytes + 1)));
        if (!found) return Unexpected{found.error()};
        const bool isBeginning =
            found->size() <= wanted->size() && std::equal(found->begin(), found->end(), wanted->begin());
        if (!isBeginning) {
            setChanged(check_.signedBytes, size);
        } else if (!wanted->empty() && found->size() == wanted->size()) {
            check_.state = State::Intact;
        }
        return {};
    }
    if (journal_.isComplete()) {  // an end that nobody has signed
        setChanged(check_.signedBytes, size);
        return {};
    }
    if (!journal_.cutOffAt()) return {};
    const Expected<bool> torn = isTorn();
    if (!torn) return Unexpected{torn.error()};
    if (!*torn) setChanged(journal_.scan().end, size);
    return {};
}

}  // namespace

Expected<SealCheck> checkSeal(const JournalReader& journal, const PublicKey& key) {
    return SealWalk(journal, key).run();
}

bool hasSignature(const JournalReader& journal) {
    return std::ranges::any_of(journal.blocks(),
                               [](const BlockPlace& block) { return block.header.type == BlockType::Signature; });
}

}  // namespace tactooth
