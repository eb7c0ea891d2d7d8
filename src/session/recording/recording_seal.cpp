// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/recording_seal.h"

#include "journal/file/seal_check.h"
#include "session/recording/event_codec.h"

namespace tactooth {
namespace {

using Verdict = SealReport::Verdict;

/// Length of the session up to a byte of the file, as far as it can be read, s.
double secondsBefore(const JournalReader& journal, std::uint64_t byte) {
    double seconds = 0;
    for (const BlockPlace& block : journal.blocks()) {
        if (block.end() > byte) break;
        if (block.header.type != BlockType::Events) continue;
        const Expected<std::vector<std::byte>> payload = journal.payload(block);
        const auto events = payload ? decodeEvents(*payload) : std::nullopt;
        if (!events) break;
        for (const SessionEvent& event : *events) seconds += secondsOf(event).value_or(0);
    }
    return seconds;
}

SealReport::Verdict verdictOf(SealCheck::State state) {
    switch (state) {
        case SealCheck::State::Intact:
            return Verdict::Intact;
        case SealCheck::State::CutOff:
            return Verdict::CutOff;
        case SealCheck::State::Changed:
            break;
    }
    return Verdict::Changed;
}

}  // namespace

Expected<SealReport> checkRecordingSeal(const SessionRecording& recording, const std::optional<PublicKey>& wanted) {
    const JournalReader& journal = recording.journal();
    SealReport report;
    report.key = recording.facts().sealKey;
    // Signatures behind a header that names no key: somebody has changed the header.
    const bool isSealed = recording.facts().isSealed || hasSignature(journal);
    if (!isSealed) return report;
    if (!report.key || (wanted && *wanted != *report.key)) {
        report.verdict = Verdict::OtherKey;
        return report;
    }
    const Expected<SealCheck> check = checkSeal(journal, *report.key);
    if (!check) return Unexpected{check.error()};
    report.verdict = verdictOf(check->state);
    report.signedBytes = check->signedBytes;
    report.signedSeconds = secondsBefore(journal, check->signedBytes);
    if (report.verdict != Verdict::Changed) return report;
    report.changedFrom = check->changedFrom;
    report.changedBefore = check->changedBefore;
    report.changedFromSecond = secondsBefore(journal, check->changedFrom);
    report.changedBeforeSecond = secondsBefore(journal, check->changedBefore);
    return report;
}

}  // namespace tactooth
