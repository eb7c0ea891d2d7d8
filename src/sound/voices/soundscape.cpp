// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/soundscape.h"

#include <algorithm>
#include <cmath>

namespace tactooth {

namespace {

// With the drill's ceiling of 0.89 the sum is below full scale, wherever the three are.
constexpr float kWaterCeiling = 0.045f, kSuctionCeiling = 0.06f;

double share(double value) { return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0; }

std::array<float, kSoundBlock>& at(SoundBlock& block, SoundSource place) {
    return block[static_cast<std::size_t>(place)];
}

}  // namespace

Soundscape::Soundscape(std::uint64_t seed, const SoundKit* kit)
    : drill_(seed),
      water_(seed * 16 + 11),
      suction_(seed * 16 + 13),
      waterLimiter_(kWaterCeiling),
      suctionLimiter_(kSuctionCeiling),
      pendingKit_(kit) {
    kitGain_.jumpTo(1.0f);
    useKit(kit);
}

void Soundscape::setMixer(const SoundMixer& mixer) {
    drill_.setMixer(mixer);
    environment_ = mixer.muted ? 0.0 : share(mixer.environment) * share(mixer.master);
}

void Soundscape::render(const DrillSoundState& target, SoundBlock& block) {
    drill_.render(target, at(block, SoundSource::Bur));
    renderEnvironment(sanitised(target), block);
    changeKit(block);
    limitExposure(block);
}

void Soundscape::renderEnvironment(const DrillSoundState& state, SoundBlock& block) {
    auto& mouth = at(block, SoundSource::Mouth);
    auto& tube = at(block, SoundSource::Suction);
    mouth.fill(0.0f);
    tube.fill(0.0f);
    for (std::size_t done = 0; done < kSoundBlock; done += kControlFrames) {
        const std::size_t frames = std::min<std::size_t>(kControlFrames, kSoundBlock - done);
        water_.addTo(std::span(mouth).subspan(done, frames), state.water, environment_);
        suction_.addTo(std::span(tube).subspan(done, frames), state.suction, state.water, environment_);
    }
    waterLimiter_.process(mouth);
    suctionLimiter_.process(tube);
}

void Soundscape::changeKit(SoundBlock& block) {
    constexpr double kSeconds = 0.004;
    kitGain_.aim(kit_ == pendingKit_ ? 1.0f : 0.0f, smoothingCoefficient(kSeconds, kSoundBlock), kSoundBlock);
    if (kitGain_.isOne()) return;
    std::array<float, kSoundBlock> gains;
    for (float& gain : gains) gain = kitGain_.next();
    for (auto& place : block) {
        for (std::size_t i = 0; i < kSoundBlock; ++i) place[i] *= gains[i];
    }
    if (kitGain_.isZero()) useKit(pendingKit_);
}

void Soundscape::useKit(const SoundKit* kit) {
    kit_ = kit;
    drill_.setKit(kit);
    water_.use(kit != nullptr && kit->water ? &*kit->water : nullptr);
    suction_.use(kit != nullptr && kit->suction ? &*kit->suction : nullptr);
}

void Soundscape::limitExposure(SoundBlock& block) {
    std::array<float, kSoundBlock> sum{};
    for (const auto& place : block) {
        for (std::size_t i = 0; i < kSoundBlock; ++i) sum[i] += place[i];
    }
    const Ramp gain = exposureLimiter_.gainFor(sum);
    if (gain.isOne()) return;
    for (auto& place : block) {
        Ramp fade = gain;
        for (float& sample : place) sample *= fade.next();
    }
}

}  // namespace tactooth
