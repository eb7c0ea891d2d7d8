// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/session_events_command.h"

#include <nlohmann/json.hpp>

#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "session/export/session_moments.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const SessionMoment& moment) {
    Json json = {{"t", moment.time}, {"event", moment.what}};
    if (moment.place) json["place"] = {moment.place->x(), moment.place->y(), moment.place->z()};
    if (moment.removed) json["removed_mm3"] = *moment.removed;
    return json;
}

void printMoment(const SessionMoment& moment) {
    std::string more;
    if (moment.place) {
        more += fmt::format("  at {:.2f}, {:.2f}, {:.2f} mm", moment.place->x(), moment.place->y(), moment.place->z());
    }
    if (moment.removed) more += fmt::format("  {:+.3f} mm^3", *moment.removed);
    print("{:9.3f} s  {:<22}{}\n", moment.time, moment.what, more);
}

}  // namespace

int runSessionEvents(const SessionEventsOptions& options) {
    const Expected<SessionRecording> recording = SessionRecording::open(options.session);
    if (!recording) return reportError(recording.error());
    Expected<SessionReplay> replay = SessionReplay::start(*recording);
    if (!replay) return reportError(replay.error());
    SessionMoments moments(*replay);
    const auto played = replay->playUntil(
        {}, [&](double time, const Tick& tick) { moments.onTick(time, tick); },
        [&](double time, const SessionEvent& event) { moments.onEvent(time, event); });
    if (!played) return reportError(played.error());
    moments.finish();
    if (options.json) {
        Json all = Json::array();
        for (const SessionMoment& moment : moments.all()) all.push_back(jsonOf(moment));
        Json json = {{"seconds", replay->seconds()}, {"same", !replay->differsAt()}, {"events", std::move(all)}};
        if (replay->differsAt()) json["differs_at_s"] = *replay->differsAt();
        print("{}\n", json.dump(2));
    } else {
        for (const SessionMoment& moment : moments.all()) printMoment(moment);
        if (replay->differsAt())
            print("The replay differs from the recording from {:.1f} s on.\n", *replay->differsAt());
    }
    return replay->differsAt() ? kExitNegative : kExitOk;
}

}  // namespace tactooth
