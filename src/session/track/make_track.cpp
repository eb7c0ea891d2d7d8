// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/track/make_track.h"

#include <array>
#include <optional>
#include <utility>

#include "session/kernel/session_kernel.h"
#include "session/simulation/cut_events.h"
#include "session/track/chunk_builder.h"
#include "session/track/messages.h"

namespace tactooth {
namespace {

/// Fills a track event by event.
class TrackMaker {
public:
    TrackMaker(std::shared_ptr<CutModel> model, SessionTrack& track)
        : model_(std::move(model)),
          track_(track),
          kernel_(model_),
          chunks_(*model_),
          events_(model_->tooth().materials()) {
        model_->noteTouched();
        (void)model_->takeTouched();
    }

    /// False if the replay differs from the recording.
    [[nodiscard]] bool apply(const SessionEvent& event) {
        const std::optional<double> elapsed = secondsOf(event);
        if (elapsed) {
            if (chunks_.isFull()) track_.append(chunks_.take());
            seconds_ += *elapsed;
        }
        if (!kernel_.apply(event)) return false;
        if (elapsed) addTick();
        if (const std::vector<BrickKey> touched = model_->takeTouched(); !touched.empty()) {
            chunks_.addStep(*model_, touched);
        }
        if (const auto* begin = std::get_if<BeginEvent>(&event)) addBur(*begin);
        if (const auto* edit = std::get_if<EditEvent>(&event); edit != nullptr && edit->published) addEdit(edit->edit);
        return true;
    }
    void end() {
        if (chunks_.hasTicks()) track_.append(chunks_.take());
    }

    [[nodiscard]] double seconds() const { return seconds_; }
    [[nodiscard]] std::uint64_t toothHash() const { return kernel_.toothHash(); }

private:
    void addTick() {
        ++ticks_;
        chunks_.add(TrackTick::of(seconds_, kernel_.tick()));
        events_.update(seconds_, kernel_.tick(), model_->loss());
        const std::vector<CutEvent>& all = events_.all();
        for (; reported_ < all.size(); ++reported_) {
            track_.add({all[reported_].time, &cutEventText(all[reported_].kind), all[reported_].place});
        }
    }
    void addBur(const BeginEvent& begin) {
        track_.add(TrackBur{ticks_, begin});
        track_.add({seconds_, &msg::kTrackBur});
    }
    void addEdit(Edit edit) {
        static constexpr std::array kTexts = {&msg::kTrackReset, &msg::kTrackUndo, &msg::kTrackRedo};  // as Edit
        track_.add({seconds_, kTexts[static_cast<std::size_t>(edit)]});
    }

    std::shared_ptr<CutModel> model_;
    SessionTrack& track_;
    SessionKernel kernel_;
    ChunkBuilder chunks_;
    CutEvents events_;
    std::size_t reported_ = 0;  // of `events_`
    double seconds_ = 0;
    std::uint64_t ticks_ = 0;
};

}  // namespace

Expected<std::shared_ptr<SessionTrack>> emptyTrack(const SessionRecording& recording, const CutModel& model) {
    const Expected<double> seconds = recording.seconds();
    if (!seconds) return Unexpected{seconds.error()};
    auto track = std::make_shared<SessionTrack>(model, *seconds);
    // At once: the first moments are shown before the last ones are simulated. makeTrack says what is wrong with it.
    if (auto mirror = recording.mirror()) track->setMirror(std::move(*mirror));
    return track;
}

void makeTrack(const SessionRecording& recording, std::shared_ptr<CutModel> model, SessionTrack& track,
               const std::stop_token& stop) {
    TrackMaker maker(std::move(model), track);
    std::optional<double> differsAt;
    const auto read = recording.forEach([&](const SessionEvent& event) {
        if (stop.stop_requested()) return false;
        if (!maker.apply(event)) differsAt = maker.seconds();
        return !differsAt;
    });
    maker.end();
    std::optional<Message> fault;
    if (!read) {
        fault = read.error();
    } else if (const auto mirror = recording.mirror(); !mirror) {
        fault = mirror.error();
    }
    if (read && !differsAt && !stop.stop_requested()) {
        const auto recorded = recording.end();
        if (!recorded) fault = recorded.error();
        if (recorded && recorded->toothHash && *recorded->toothHash != maker.toothHash()) differsAt = maker.seconds();
    }
    track.finish(differsAt, std::move(fault));
}

}  // namespace tactooth
