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
    bool headphones = false;  ///< place the sound by HRTF instead of by left-right balance
    bool room = true;         ///< with the sound of the surgery
};

/// Plays on the default sound device of the system from its own thread. Without a sound card, or when it is unplugged,
/// it continues silently and tries again every few seconds. Construction and destruction take only as long as opening
/// or closing the device.
class OpenAlOutput final : public SoundOutput {
public:
    explicit OpenAlOutput(const OpenAlOutputSettings& settings = {});

    void publish(const DrillSoundState& state) override { state_.write(state); }
    void setMixer(const SoundMixer& mixer) override { mixer_.write(mixer); }
    void setPlacement(const SoundPlacement& placement) override { placement_.write(placement); }
    void setHeadphones(bool headphones) override { headphones_.store(headphones, std::memory_order_relaxed); }
    void setRoom(bool room) override { room_.store(room, std::memory_order_relaxed); }
    void setKit(std::shared_ptr<const SoundKit> kit) override;
    [[nodiscard]] SoundStatus status() const override { return status_.load(std::memory_order_relaxed); }

    /// Number of blocks that the device has taken so far, and of its underruns.
    [[nodiscard]] std::uint64_t playedBlocks() const { return playedBlocks_.load(std::memory_order_relaxed); }
    [[nodiscard]] std::uint64_t underruns() const { return underruns_.load(std::memory_order_relaxed); }
    /// Largest delay from the publication of a state before the newest block to the ear, s: since the block before it
    /// was made, through queue and device (as far as OpenAL reports it). 0 before the first block.
    [[nodiscard]] double latency() const { return latency_.load(std::memory_order_relaxed); }

private:
    void run(const std::stop_token& stop);
    /// True if it should try again at once.
    bool playOnce(const std::stop_token& stop);
    class Feeder;

    OpenAlOutputSettings settings_;
    TripleBuffer<DrillSoundState> state_;
    TripleBuffer<SoundMixer> mixer_;
    TripleBuffer<SoundPlacement> placement_;
    struct NumberedKit {
        const SoundKit* kit = nullptr;
        std::uint64_t number = 0;  // number of kits that have been set
    };
    TripleBuffer<NumberedKit> kit_;
    std::atomic<std::uint64_t> activeKit_{0};            // number of the only kit that is played
    std::vector<std::shared_ptr<const SoundKit>> kits_;  // for the thread that sets them: kits that may still be played
    std::uint64_t kitsSet_ = 0;                          // likewise
    std::atomic<bool> headphones_;
    std::atomic<bool> room_;
    std::atomic<SoundStatus> status_{SoundStatus::Starting};
    std::atomic<std::uint64_t> playedBlocks_{0};
    std::atomic<std::uint64_t> underruns_{0};
    std::atomic<double> latency_{0.0};
    std::jthread thread_;  // last member: it uses all others
};

}  // namespace tactooth
