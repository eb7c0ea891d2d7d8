// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/seal_text.h"

#include <fmt/format.h>

#include "session/recording/station_key.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;
using Verdict = SealReport::Verdict;

const char* wordOf(Verdict verdict) {
    switch (verdict) {
        case Verdict::NotSealed:
            return "not_sealed";
        case Verdict::Intact:
            return "intact";
        case Verdict::CutOff:
            return "cut_off";
        case Verdict::Changed:
            return "changed";
        case Verdict::OtherKey:
            break;
    }
    return "other_key";
}

bool isOfThisStation(const SealReport& report) { return report.key && knownStationKey() == report.key; }

}  // namespace

std::string sealText(const SealReport& report) {
    if (report.verdict == Verdict::NotSealed) return "Not sealed: nobody has signed this recording.";
    if (!report.key) return "The recording has signatures, but its head names no key: it was changed.";
    const std::string key = keyText(*report.key) + (isOfThisStation(report) ? " (this station)" : "");
    if (report.verdict == Verdict::Intact) {
        return fmt::format("Sealed by {}: complete, and no byte was changed.", key);
    }
    if (report.verdict == Verdict::CutOff) {
        return fmt::format(
            "Sealed by {}: unchanged up to {:.1f} s (byte {}). The end is missing: it was cut off there.", key,
            report.signedSeconds, report.signedBytes);
    }
    if (report.verdict == Verdict::OtherKey) return fmt::format("Sealed by another key: {}.", key);
    return fmt::format(
        "Sealed by {}: changed after {:.1f} s (in bytes {} to {} of the file). Only what is before is as it was "
        "signed.",
        key, report.changedFromSecond, report.changedFrom, report.changedBefore - 1);
}

Json sealJson(const SealReport& report) {
    Json json = {{"verdict", wordOf(report.verdict)}, {"public_key", nullptr}};
    if (report.verdict == Verdict::NotSealed) return json;
    if (report.key) json["public_key"] = keyText(*report.key);
    json["this_station"] = isOfThisStation(report);
    if (report.verdict == Verdict::OtherKey) return json;
    json["signed_s"] = report.signedSeconds;
    json["signed_bytes"] = report.signedBytes;
    if (report.verdict != Verdict::Changed) return json;
    json["changed_from_s"] = report.changedFromSecond;
    json["changed_before_s"] = report.changedBeforeSecond;
    json["changed_from_byte"] = report.changedFrom;
    json["changed_before_byte"] = report.changedBefore;
    return json;
}

}  // namespace tactooth
