// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>

#include "session/live/live_runner.h"
#include "session/model/instrument_set.h"
#include "sound/output/sound_output.h"

namespace tactooth {

class LiveStream;

/// Where the ticks of a runner go: what is heard of them to the sound output, and all of them to a stream.
class TickOutput {
public:
    /// Both outlive this, and this the runner. `instruments`: those that are off are not heard.
    TickOutput(SoundOutput& sound, const InstrumentSet& instruments) : sound_(sound), instruments_(instruments) {}

    /// The listeners that are made from now on send each tick there, too; null: nowhere.
    void streamTo(std::shared_ptr<LiveStream> stream);
    /// Whether ticks may go there. It holds at once, for the listeners that run, too.
    void setStreamAllowed(bool allowed) { streamAllowed_ = allowed; }

    /// For a runner with these settings and this bur.
    [[nodiscard]] LiveRunner::TickListener listener(const HapticSettings& haptics, const BurEdge& edge);

private:
    SoundOutput& sound_;
    const InstrumentSet& instruments_;
    std::shared_ptr<LiveStream> stream_;
    std::atomic<bool> streamAllowed_{true};
};

}  // namespace tactooth
