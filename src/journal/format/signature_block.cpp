// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/format/signature_block.h"

#include <string_view>

#include "geometry/util/assert.h"
#include "geometry/util/byte_stream.h"
#include "geometry/util/byte_text.h"

namespace tactooth {
namespace {

/// Keeps what is signed here apart from all else that the same key may sign, now or later.
constexpr std::string_view kPurpose = "Tactooth sealed recording 1";

}  // namespace

std::vector<std::byte> signedMessage(const SealPlace& place, const Digest& digest) {
    ByteWriter out;
    out.putAll(asBytes(kPurpose));
    out.put(place.offset);
    out.put(place.tick);
    out.put(place.point);
    out.put(digest);
    return out.take();
}

JournalBlock signatureBlock(const SealPlace& place, const SignatureBytes& signature) {
    ByteWriter out;
    out.put(place.point);
    out.put(signature);
    TACTOOTH_ASSERT(out.bytes().size() == kSignaturePayloadBytes);
    return {BlockType::Signature, place.tick, 0, out.take()};
}

std::optional<StoredSignature> parseSignature(std::span<const std::byte> payload) {
    if (payload.size() != kSignaturePayloadBytes) return std::nullopt;
    ByteReader in(payload);
    StoredSignature stored;
    const auto point = in.get<std::uint32_t>();
    stored.signature = in.get<SignatureBytes>();
    if (point > static_cast<std::uint32_t>(SealPoint::End)) return std::nullopt;
    stored.point = static_cast<SealPoint>(point);
    return stored;
}

bool hasSignatureForm(const BlockHeader& header) {
    return header.type == BlockType::Signature && header.flags == 0 && header.ticks == 0 &&
           header.storedBytes == kSignaturePayloadBytes && header.rawBytes == kSignaturePayloadBytes;
}

}  // namespace tactooth
