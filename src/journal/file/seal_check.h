// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/util/expected.h"
#include "journal/codec/signing_key.h"
#include "journal/file/journal_reader.h"

namespace tactooth {

/// What the signatures of a recording prove.
struct SealCheck {
    enum class State {
        Intact,   ///< complete, and each byte is as the owner of the key has signed it
        CutOff,   ///< as signed up to `signedBytes`; the end is missing, and the rest, if any, is not signed
        Changed,  ///< as signed up to `signedBytes`; there is a changed byte before `changedBefore`
    };
    State state = State::CutOff;
    std::size_t signatures = 0;       ///< that are valid, up to the first one that is not
    std::uint64_t signedBytes = 0;    ///< of the file, from its beginning; up to the end of the last valid signature
    std::uint64_t changedFrom = 0;    ///< if Changed: the first changed byte is not before this one,
    std::uint64_t changedBefore = 0;  ///< and before this one
};

/// Checks each byte of a recording against its signatures. `key`: of the one who is said to have signed it. Takes no
/// more memory than a piece of the file. Fails with one sentence if the file cannot be read.
[[nodiscard]] Expected<SealCheck> checkSeal(const JournalReader& journal, const PublicKey& key);

/// Whether there is a block with a signature, whatever it is worth.
[[nodiscard]] bool hasSignature(const JournalReader& journal);

}  // namespace tactooth
