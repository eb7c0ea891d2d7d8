// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/journal_sealer.h"

#include <utility>

#include "geometry/util/assert.h"

namespace tactooth {

JournalSealer::JournalSealer(std::shared_ptr<const SigningKey> key) : key_(std::move(key)) {
    TACTOOTH_ASSERT(key_ != nullptr);
}

void JournalSealer::noteWritten(std::span<const std::byte> bytes) {
    TACTOOTH_ASSERT(!bytes.empty());
    digester_.add(bytes);
    bytes_ += bytes.size();
    hasUnsigned_ = true;
}

JournalBlock JournalSealer::sign(std::uint64_t tick, SealPoint point) const {
    TACTOOTH_ASSERT(bytes_ > 0);
    const SealPlace place{bytes_, tick, point};
    return signatureBlock(place, key_->sign(signedMessage(place, digester_.digest())));
}

}  // namespace tactooth
