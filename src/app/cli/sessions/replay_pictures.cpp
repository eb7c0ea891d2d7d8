// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/replay_pictures.h"

#include <utility>

#include "app/cli/pictures/render_arguments.h"
#include "app/common/inspection.h"
#include "app/common/recorded_eye.h"
#include "app/common/tooth_zones.h"
#include "session/recording/mirror_moments.h"

namespace tactooth {

ReplayPictures::ReplayPictures(OffscreenRenderer renderer, const OrbitCamera& camera, ImageSize size,
                               const CutModel& model, std::vector<MirrorMoment> mirror)
    : renderer_(std::move(renderer)),
      camera_(camera),
      size_(size),
      around_(bodiesAround(model)),
      handpieces_(HandpieceMeshes::make()),
      held_(std::move(mirror)) {}

Expected<ReplayPictures> ReplayPictures::create(const std::optional<std::string>& view, ImageSize size,
                                                const SessionRecording& recording, const CutModel& model) {
    const auto direction = parseView(view.value_or("dentist"));
    if (!direction) return Unexpected{direction.error()};
    OrbitCamera camera;
    if (direction->standard) {
        camera.setView(*direction->standard);
    } else {
        camera.setView(direction->free);
    }
    constexpr double kAbove = 8;  // mm: the head of the handpiece
    camera.fit(crownBox(model.tooth().outer()->tree().box(), kAbove), size.aspect());
    Expected<std::vector<MirrorMoment>> mirror = recording.mirror();
    if (!mirror) return Unexpected{mirror.error()};
    if (const auto eye = firstEye(*mirror); eye && !view) camera = lookingFrom(camera, *eye, size);
    Expected<OffscreenRenderer> renderer = OffscreenRenderer::create();
    if (!renderer) return Unexpected{renderer.error()};
    return ReplayPictures(std::move(*renderer), camera, size, model, std::move(*mirror));
}

Expected<Image> ReplayPictures::draw(const SessionReplay& replay, const Tick& tick, double time) {
    SceneContents contents;
    contents.tooth = replay.model().surface();
    contents.around = around_;
    contents.glass = true;  // as in the window
    contents.camera = camera_.camera();
    contents.mirror = mirror_.at(sightAt(held_, replay.ticks()));
    contents.materials = MaterialTable(replay.model().tooth().materials());
    if (replay.bur()) {
        const Instrument& instrument = replay.bur()->instrument;
        if (std::exchange(shape_, instrument.shape) != instrument.shape) bur_ = ReplayBur::of(instrument);
        contents.materials = replay.bur()->settings.materials;
        if (tick.number > 0) contents.tool = bur_.at(tick, time, handpieces_.of(replay.bur()->settings.spindle));
    }
    contents.zones = toothZones(replay.model().tooth(), contents.materials);
    return renderer_.render(makeScene(contents), size_);
}

}  // namespace tactooth
