// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/util/expected.h"
#include "journal/codec/signing_key.h"
#include "session/recording/session_recording.h"

namespace tactooth {

/// What the seal of a recording proves.
struct SealReport {
    enum class Verdict {
        NotSealed,  ///< nobody has signed it
        Intact,     ///< complete, and as it was signed
        CutOff,     ///< as it was signed up to `signedSeconds`; the end is missing
        Changed,    ///< a byte was changed
        OtherKey,   ///< another key has signed it, or the header names no key
    };
    Verdict verdict = Verdict::NotSealed;
    std::optional<PublicKey> key;    ///< that the header names
    double signedSeconds = 0;        ///< of the session, that are as signed
    std::uint64_t signedBytes = 0;   ///< of the file, the same
    double changedFromSecond = 0;    ///< if Changed: the first change is not before this second of the session,
    double changedBeforeSecond = 0;  ///< and before this one; the same if nothing of the rest can be read
    std::uint64_t changedFrom = 0, changedBefore = 0;  ///< the same in bytes of the file

    [[nodiscard]] bool isProof() const { return verdict == Verdict::Intact; }
};

/// Checks the seal of a recording. `wanted`: the key that must have signed it; nothing: the one that the header names,
/// which proves only that the owner of that key has signed. Fails with one sentence if the file cannot be read.
[[nodiscard]] Expected<SealReport> checkRecordingSeal(const SessionRecording& recording,
                                                      const std::optional<PublicKey>& wanted = {});

}  // namespace tactooth
