// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/first_touch.h"

namespace tactooth {

bool FirstTouch::search() {
    if (time_) return true;
    const bool isFinished = track_->isFinished();  // before the ticks: none comes after it
    const std::uint64_t ready = track_->ticks();
    while (searched_ < ready && !time_) {
        const std::shared_ptr<const TrackChunk> chunk = track_->chunkAt(searched_ / TrackChunk::kTicks);
        for (auto i = static_cast<std::size_t>(searched_ % TrackChunk::kTicks); i < chunk->ticks.size(); ++i) {
            ++searched_;
            if (chunk->ticks[i].contacts == 0) continue;
            time_ = chunk->ticks[i].time;
            break;
        }
    }
    return time_ || isFinished;
}

}  // namespace tactooth
