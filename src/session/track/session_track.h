// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "geometry/util/message.h"
#include "session/kernel/session_event.h"
#include "session/recording/mirror_sight.h"
#include "session/simulation/cut_model.h"
#include "session/track/track_chunk.h"

namespace tactooth {

/// What happened at a moment of a session, for people.
struct TrackEvent {
    double time = 0;                    ///< s since the session began
    const MessageText* text = nullptr;  ///< never null in a track
    std::optional<Vec3> place = {};     ///< the bur's tip in the tooth's frame, mm
};

/// A bur that begins to work.
struct TrackBur {
    std::uint64_t afterTicks = 0;
    BeginEvent begin;
};

/// A recorded session in memory, so that each moment can be seen at once: all ticks, and the changes of the tooth from
/// one moment to the next. One thread makes it (makeTrack) while others read what is there. A moment is a number of
/// ticks: 0 is before the first, and n is after tick n with all that came before the next one.
class SessionTrack {
public:
    /// `start`: the tooth before the first event. `seconds`: length of the recording.
    SessionTrack(const CutModel& start, double seconds);

    // By the thread that makes it.
    void append(TrackChunk chunk);
    void add(const TrackEvent& event);
    void add(TrackBur bur);
    /// How the mirror was held, in the order of the ticks.
    void setMirror(std::vector<MirrorMoment> mirror);
    /// Nothing follows. `differsAt`: where the replay was found to differ from the recording, s. `fault`: why the
    /// recording could not be read further.
    void finish(std::optional<double> differsAt, std::optional<Message> fault);

    // Any thread.
    [[nodiscard]] std::uint64_t ticks() const;
    /// Time of the last moment that is there, s.
    [[nodiscard]] double seconds() const;
    /// Length of the recording as it is known before all is there, s.
    [[nodiscard]] double expectedSeconds() const { return expectedSeconds_; }
    [[nodiscard]] bool isFinished() const;
    [[nodiscard]] std::optional<double> differsAt() const;
    [[nodiscard]] std::optional<Message> fault() const;
    [[nodiscard]] std::vector<TrackEvent> events() const;
    /// How the mirror was held; empty: the recording does not say it.
    [[nodiscard]] std::vector<MirrorMoment> mirror() const;
    /// How it was held at a moment, which need not be there yet; not shown where the recording does not say it.
    [[nodiscard]] MirrorSight mirrorAt(std::uint64_t moment) const;
    /// The bur at work at a moment; null before the first one.
    [[nodiscard]] std::shared_ptr<const TrackBur> burAt(std::uint64_t moment) const;
    /// The last moment that is not later than `time`, s.
    [[nodiscard]] std::uint64_t momentAt(double time) const;
    /// The tick that a moment follows; an empty one for moment 0. The moment is there.
    [[nodiscard]] TrackTick tickBefore(std::uint64_t moment) const;
    /// Calls `visit(tick)` with the ticks of the moments from `first` (excluded) to `last`.
    template <class Visit>
    void forEachTick(std::uint64_t first, std::uint64_t last, const Visit& visit) const {
        for (std::uint64_t i = first; i < last;) {
            const std::shared_ptr<const TrackChunk> chunk = chunkAt(i / TrackChunk::kTicks);
            const std::uint64_t end = std::min(last, (i / TrackChunk::kTicks + 1) * TrackChunk::kTicks);
            for (; i < end; ++i) visit(chunk->ticks[i % TrackChunk::kTicks]);
        }
    }
    /// Chunk number `index`, which is there.
    [[nodiscard]] std::shared_ptr<const TrackChunk> chunkAt(std::uint64_t index) const;
    /// Memory, bytes.
    [[nodiscard]] std::size_t bytes() const;

    /// A copy of the tooth before the first event.
    [[nodiscard]] std::shared_ptr<CutModel> startModel() const;
    [[nodiscard]] const std::shared_ptr<const LayeredTooth>& tooth() const { return tooth_; }
    [[nodiscard]] const Surroundings& surroundings() const { return surroundings_; }

private:
    std::shared_ptr<const LayeredTooth> tooth_;
    double voxel_;  // mm
    std::map<BrickKey, CutField> startFields_;
    ToothLoss startLoss_;
    Surroundings surroundings_;
    double expectedSeconds_;

    mutable std::mutex mutex_;  // of all below
    std::vector<std::shared_ptr<const TrackChunk>> chunks_;
    std::vector<TrackEvent> events_;
    std::vector<std::shared_ptr<const TrackBur>> burs_;
    std::vector<MirrorMoment> mirror_;
    std::uint64_t ticks_ = 0;
    std::size_t bytes_ = 0;
    bool finished_ = false;
    std::optional<double> differsAt_;
    std::optional<Message> fault_;
};

}  // namespace tactooth
