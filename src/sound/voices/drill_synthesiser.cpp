// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/drill_synthesiser.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tactooth {

namespace {

constexpr double kMasterLagSeconds = 0.01;

double volume(double value) { return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0; }

}  // namespace

DrillSynthesiser::DrillSynthesiser(std::uint64_t seed)
    : rotation_(seed * 16 + 1), motor_(seed * 16 + 2), cutting_(seed * 16 + 8), glide_(seed * 16 + 12) {}

void DrillSynthesiser::setMixer(const SoundMixer& mixer) {
    mixer_ = {.motor = volume(mixer.motor),
              .cutting = volume(mixer.cutting),
              .master = volume(mixer.master),
              .muted = mixer.muted};
}

void DrillSynthesiser::setKit(const SoundKit* kit) {
    motor_.use(kit != nullptr && kit->motor ? &*kit->motor : nullptr);
    cutting_.use(kit);
}

void DrillSynthesiser::render(const DrillSoundState& target, std::span<float> mono) {
    const DrillSoundState goal = sanitised(target);
    const double startRpm = speedRpm_;
    const std::size_t total = mono.size();
    for (std::size_t done = 0; done < total;) {
        const std::size_t frames = std::min<std::size_t>(kControlFrames, total - done);
        const double share = static_cast<double>(done + frames) / static_cast<double>(total);
        DrillSoundState state = goal;
        state.speedRpm = speedRpm_ = startRpm + (goal.speedRpm - startRpm) * share;
        renderRun(state, mono.subspan(done, frames));
        done += frames;
    }
    limiter_.process(mono);
}

void DrillSynthesiser::renderRun(const DrillSoundState& state, std::span<float> run) {
    std::array<double, kControlFrames> turns;
    const std::span turnsPerFrame(turns.data(), run.size());
    rotation_.advanceTo(state.speedRpm, turnsPerFrame);

    std::fill(run.begin(), run.end(), 0.0f);
    motor_.addTo(run, state, mixer_.motor, turnsPerFrame);
    cutting_.addTo(run, state, mixer_.cutting, turnsPerFrame);
    tap_.addTo(run, state, mixer_.cutting);
    glide_.addTo(run, state, mixer_.cutting);

    const int frames = static_cast<int>(run.size());
    master_.aim(mixer_.muted ? 0.0f : static_cast<float>(mixer_.master),
                smoothingCoefficient(kMasterLagSeconds, frames), frames);
    for (float& sample : run) sample *= master_.next();
}

}  // namespace tactooth
