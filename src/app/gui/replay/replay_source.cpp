// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_source.h"

#include <utility>

#include "app/common/tooth_zones.h"
#include "session/track/make_track.h"

namespace tactooth {

ReplaySource::ReplaySource(std::filesystem::path file, SessionRecording recording, std::shared_ptr<SessionTrack> track,
                           std::shared_ptr<CutModel> model)
    : file_(std::move(file)),
      recording_(std::move(recording)),
      track_(std::move(track)),
      uncut_(track_->startModel()),
      around_(bodiesAround(*uncut_)),
      follower_(track_),
      maker_([this, model = std::move(model)](const std::stop_token& stop) {
          makeTrack(recording_, model, *track_, stop);
      }) {}

Expected<std::shared_ptr<ReplaySource>> ReplaySource::open(const std::filesystem::path& file) {
    Expected<SessionRecording> recording = SessionRecording::open(file);
    if (!recording) return Unexpected{recording.error()};
    Expected<std::shared_ptr<CutModel>> model = recording->makeModel();
    if (!model) return Unexpected{model.error()};
    Expected<std::shared_ptr<SessionTrack>> track = emptyTrack(*recording, **model);
    if (!track) return Unexpected{track.error()};
    return std::shared_ptr<ReplaySource>(
        new ReplaySource(file, std::move(*recording), std::move(*track), std::move(*model)));
}

MaterialTable ReplaySource::materialsAt(std::uint64_t moment) const {
    const std::shared_ptr<const TrackBur> bur = track_->burAt(moment);
    return bur != nullptr ? bur->begin.settings.materials : MaterialTable(uncut_->tooth().materials());
}

const ReplayBur& ReplaySource::shownBur(const std::shared_ptr<const TrackBur>& bur) {
    const auto known = burs_.find(bur);
    return known != burs_.end() ? known->second
                                : burs_.emplace(bur, ReplayBur::of(bur->begin.instrument)).first->second;
}

SceneContents ReplaySource::contentsAt(std::uint64_t moment, const HandpieceMeshes& handpieces) {
    follower_.follow(moment);
    SceneContents contents;
    contents.tooth = follower_.shown().surface;
    contents.materials = materialsAt(moment);
    contents.zones = toothZones(uncut_->tooth(), contents.materials);
    contents.around = around_;
    contents.mirror = mirror_.at(track_->mirrorAt(moment));
    const std::shared_ptr<const TrackBur> bur = track_->burAt(moment);
    if (bur == nullptr || moment == bur->afterTicks) return contents;  // nobody knows yet where the hand is
    const Tick tick = track_->tickBefore(moment).tick();
    contents.tool = shownBur(bur).at(tick, tick.time, handpieces.of(bur->begin.settings.spindle));
    return contents;
}

}  // namespace tactooth
