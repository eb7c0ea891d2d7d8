// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "journal/codec/digest.h"
#include "journal/codec/signing_key.h"
#include "journal/format/signature_block.h"

namespace tactooth {

/// Signs a recording while it is written. Each signature covers all bytes before it, so a crash leaves a file that is
/// signed up to the last one. For the thread that writes.
class JournalSealer {
public:
    /// Not null.
    explicit JournalSealer(std::shared_ptr<const SigningKey> key);

    /// These bytes were written, as the next ones of the file.
    void noteWritten(std::span<const std::byte> bytes);
    /// Whether something was written that no signature covers.
    [[nodiscard]] bool hasUnsigned() const { return hasUnsigned_; }
    /// A block that signs all that was written. Its own bytes need no signature before others follow.
    [[nodiscard]] JournalBlock sign(std::uint64_t tick, SealPoint point) const;
    /// That block was written: see noteWritten.
    void noteSigned() { hasUnsigned_ = false; }

private:
    std::shared_ptr<const SigningKey> key_;
    Digester digester_;
    std::uint64_t bytes_ = 0;
    bool hasUnsigned_ = false;
};

}  // namespace tactooth
