// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/session_verify_command.h"

#include "app/cli/sessions/messages.h"
#include "app/cli/sessions/replay_command.h"
#include "app/cli/sessions/seal_text.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "geometry/util/display_text.h"

namespace tactooth {
namespace {

using Verdict = SealReport::Verdict;

/// Without the replay: what was changed proves nothing.
int reportWithoutReplay(const SealReport& report, bool json) {
    if (json) {
        print("{}\n", nlohmann::ordered_json{{"same", nullptr}, {"seal", sealJson(report)}}.dump(2));
    } else {
        print("{}\n", sealText(report));
    }
    return kExitNegative;
}

}  // namespace

int runSessionVerify(const SessionVerifyOptions& options) {
    const std::optional<PublicKey> wanted = parseKey(options.key);
    if (!options.key.empty() && !wanted) return reportError({msg::kSealKeyForm, displayText(options.key)});
    const Expected<SessionRecording> recording = SessionRecording::open(options.session);
    if (!recording) return reportError(recording.error());
    const Expected<SealReport> seal = checkRecordingSeal(*recording, wanted);
    if (!seal) return reportError(seal.error());
    const bool isRefused = seal->verdict == Verdict::Changed || seal->verdict == Verdict::OtherKey ||
                           (seal->verdict == Verdict::NotSealed && wanted);
    if (isRefused) return reportWithoutReplay(*seal, options.json);
    ReplayOptions replay;
    replay.session = options.session;
    replay.json = options.json;
    replay.seal = *seal;
    const int replayed = runReplay(replay);
    return replayed == kExitOk && seal->verdict == Verdict::CutOff ? kExitNegative : replayed;
}

}  // namespace tactooth
