// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <thread>
#include <vector>

#include "geometry/util/triple_buffer.h"
#include "sound/output/sound_output.h"

namespace tactooth {

struct OpenAlOutputSettings {
    std::uint64_t seed = 1;
    bool headphones = false;  ///< place the sound by the ears' own filtering (HRTF) instead of by left-right balance
};

/// Plays on the system's default sound device from a thread of its own. No sound card, or one that is unplugged: it
/// goes on silently and tries again every few seconds. Construction and destruction take no longer than opening or
/// closing the device.
class OpenAlOutput final : public SoundOutput {
public:
    explicit OpenAlOutput(const OpenAlOutputSettings& settings = {});

    void publish(const DrillSoundState& state) override { state_.write(state); }
    void setMixer(const SoundMixer& mixer) override { mixer_.write(mixer); }
    void setPlacement(const SoundPlacement& placement) override { placement_.write(placement); }
    void setHeadphones(bool headphones) override { headphones_.store(headphones, std::memory_order_relaxed); }
    void setKit(std::shared_ptr<const SoundKit> kit) override;
    [[nodiscard]] SoundStatus status() const override { return status_.load(std::memory_order_relaxed); }

    /// Blocks handed to the device so far, and how often it had run out of them.
    [[nodiscard]] std::uint64_t playedBlocks() const { return playedBlocks_.load(std::memory_order_relaxed); }
    [[nodiscard]] std::uint64_t underruns() const { return underruns_.load(std::memory_order_relaxed); }
    /// The longest way that a state published before the newest block can have had to the ear, s: since the block
    /// before it was made, through queue and device (as far as that tells). 0 before there is one.
    [[nodiscard]] double latency() const { return latency_.load(std::memory_order_relaxed); }

private:
    void run(const std::stop_token& stop);
    /// True if it should be tried again at once.
    bool playOnce(const std::stop_token& stop);
    class Feeder;

    OpenAlOutputSettings settings_;
    TripleBuffer<DrillSoundState> state_;
    TripleBuffer<SoundMixer> mixer_;
    TripleBuffer<SoundPlacement> placement_;
    struct NumberedKit {
        const SoundKit* kit = nullptr;
        std::uint64_t number = 0;  // how many have been set
    };
    TripleBuffer<NumberedKit> kit_;
    std::atomic<std::uint64_t> activeKit_{0};            // number of the one that alone is being played
    std::vector<std::shared_ptr<const SoundKit>> kits_;  // of the thread that sets them: what may still be playing
    std::uint64_t kitsSet_ = 0;                          // likewise
    std::atomic<bool> headphones_;
    std::atomic<SoundStatus> status_{SoundStatus::Starting};
    std::atomic<std::uint64_t> playedBlocks_{0};
    std::atomic<std::uint64_t> underruns_{0};
    std::atomic<double> latency_{0.0};
    std::jthread thread_;  // last: it uses all of the above
};

}  // namespace tactooth
