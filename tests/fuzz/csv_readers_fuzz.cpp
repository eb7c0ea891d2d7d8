// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: a trajectory and a sound profile are refused with a sentence, or are poses and sounds in order.
#include <cmath>

#include "fuzz/fuzz_target.h"
#include "session/audio/sound_profile.h"
#include "session/scripts/trajectory.h"

namespace tactooth::test {
namespace {

bool isTrajectory(std::string_view text) {
    const auto trajectory = parseTrajectory(text, "fuzz");
    if (!trajectory) return requireSentence(trajectory.error(), 1000), false;
    require(!trajectory->empty(), "a trajectory has a pose");
    double last = trajectory->front().time;
    for (const TimedPose& pose : *trajectory) {
        require(std::isfinite(pose.time) && pose.time >= last, "time goes forward");
        require(pose.toolInTooth.position.allFinite(), "places are finite");
        require(std::abs(pose.toolInTooth.rotation.norm() - 1) < 1e-12, "quaternions are unit");
        last = pose.time;
    }
    return true;
}

bool isSoundProfile(std::string_view text) {
    const auto track = parseSoundProfile(text, "fuzz", spindlePresets().front(), MaterialTable());
    if (!track) return requireSentence(track.error(), 1000), false;
    require(track->back().time > 0 && track->back().time <= kMaxSoundLength,
            "a profile spans a time that can be heard");
    for (const TimedSoundState& moment : *track) {
        require(std::isfinite(moment.state.load) && moment.state.load >= 0 && moment.state.load <= 1,
                "load is a share");
        require(moment.state.speedRpm >= 0 && moment.state.speedRpm <= 1e6, "speeds are those of drives");
    }
    return true;
}

bool accepts(std::span<const std::byte> bytes) {
    const bool isPoses = isTrajectory(asText(bytes));
    return isSoundProfile(asText(bytes)) || isPoses;
}

const AddFuzzTarget added({"csv", accepts, 0.01});  // a comma more or less is enough to be refused

}  // namespace
}  // namespace tactooth::test
