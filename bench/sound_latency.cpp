// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// How long from a parameter to its sample, end to end: knocks on enamel, and listens on standard input to what the
// sound server plays (stereo, 32-bit floats, kSoundRate). With PulseAudio or PipeWire:
//   parec --latency-msec=1 -d @DEFAULT_MONITOR@ --raw --format=float32le --rate=48000 --channels=2 | sound_latency
// Prints one CSV line; the way through the recorder is in it.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>
#include <vector>

#include "session/audio/material_sound.h"
#include "sound/files/sound_format.h"
#include "sound/output/audio_libraries.h"
#include "sound/output/openal_output.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr float kOnsetLevel = 2e-3f;  // a knock begins in silence

std::int64_t now() { return Clock::now().time_since_epoch() / 1ns; }

/// Notes when the first loud sample after `arm()` came in.
class OnsetDetector {
public:
    void arm() {
        onsetAt_ = 0;
        armed_ = true;
    }
    [[nodiscard]] std::int64_t onsetAt() const { return onsetAt_; }

    void listen() {
        std::array<float, 2048> samples;
        for (;;) {
            const ssize_t bytes = read(STDIN_FILENO, samples.data(), sizeof samples);
            if (bytes <= 0) return;
            const std::int64_t time = now();
            const std::ptrdiff_t count = bytes / static_cast<ssize_t>(sizeof(float));
            const auto end = samples.begin() + count;
            const auto loud = std::find_if(samples.begin(), end, [](float s) { return std::abs(s) > kOnsetLevel; });
            if (loud == end || !armed_.exchange(false)) continue;
            onsetAt_ = time - (end - loud) / 2 * 1'000'000'000 / kSoundRate;
        }
    }

private:
    std::atomic<bool> armed_{false};
    std::atomic<std::int64_t> onsetAt_{0};
};

void run(std::vector<double>& measured, std::vector<double>& reported) {
    constexpr int kImpacts = 100;
    static OnsetDetector onsetDetector;
    std::thread([] { onsetDetector.listen(); }).detach();  // reads until the input ends
    OpenAlOutput output;
    DrillSoundState state;
    state.material = characterOf(MaterialTable(), builtinMaterials().withRole(MaterialRole::Enamel));
    state.contactSpeed = 100.0;
    const auto publishFor = [&](Clock::duration time) {
        for (const auto end = Clock::now() + time; Clock::now() < end; std::this_thread::sleep_for(1ms))
            output.publish(state);
    };
    publishFor(4s);  // a sound server may take its time to start
    for (int knock = 0; knock < kImpacts; ++knock) {
        publishFor(250ms + knock % 17 * 1300us);  // at any moment of a block
        onsetDetector.arm();
        ++state.contactCount;
        const std::int64_t start = now();
        output.publish(state);
        reported.push_back(1e3 * output.latency());
        publishFor(200ms);
        if (onsetDetector.onsetAt() > 0)
            measured.push_back(1e-6 * static_cast<double>(onsetDetector.onsetAt() - start));
    }
}

}  // namespace
}  // namespace tactooth

int main() {
    tactooth::prepareAudioLibraries();
    std::vector<double> measured, reported;
    tactooth::run(measured, reported);
    if (measured.empty()) {
        std::fputs("nothing was heard on standard input; see the head of bench/sound_latency.cpp\n", stderr);
        return 2;
    }
    std::sort(measured.begin(), measured.end());
    std::sort(reported.begin(), reported.end());
    std::puts("knocks_heard,p50_ms,p90_ms,max_ms,told_p50_ms,told_max_ms");
    std::printf("%zu,%.1f,%.1f,%.1f,%.1f,%.1f\n", measured.size(), measured[measured.size() / 2],
                measured[measured.size() * 9 / 10], measured.back(), reported[reported.size() / 2], reported.back());
}
