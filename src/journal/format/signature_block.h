// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "journal/codec/digest.h"
#include "journal/codec/signing_key.h"
#include "journal/format/block_header.h"
#include "journal/format/journal_block.h"

namespace tactooth {

/// Where in a recording a signature stands. The numbers are those of the file.
enum class SealPoint : std::uint32_t {
    Running = 0,  ///< the recording goes on
    End = 1,      ///< only the Closed block follows
};

/// What is known of a Signature block before it is signed.
struct SealPlace {
    std::uint64_t offset = 0;  ///< of the block in the file: so many bytes are signed
    std::uint64_t tick = 0;    ///< first tick of the block
    SealPoint point = SealPoint::Running;
};

/// The bytes that are signed. `digest`: of the file before the block.
[[nodiscard]] std::vector<std::byte> signedMessage(const SealPlace& place, const Digest& digest);

/// Payload of the block: the point and the signature.
inline constexpr std::size_t kSignaturePayloadBytes = sizeof(SealPoint) + sizeof(SignatureBytes);
[[nodiscard]] JournalBlock signatureBlock(const SealPlace& place, const SignatureBytes& signature);

struct StoredSignature {
    SealPoint point = SealPoint::Running;
    SignatureBytes signature{};
};
/// Nothing for a payload of another form.
[[nodiscard]] std::optional<StoredSignature> parseSignature(std::span<const std::byte> payload);

/// Whether a Signature block has the one form that signatureBlock gives it: what the signature does not cover of its
/// own block is fixed, so no byte of it can be another one.
[[nodiscard]] bool hasSignatureForm(const BlockHeader& header);

}  // namespace tactooth
