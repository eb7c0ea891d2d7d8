// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Plays a cut on the sound device in real time while one core is kept busy: does the sound ever run dry, how long is
// the way from a parameter to its sample, and what of a core does all of it take (OpenAL's mixer included)?
//   sound_soak [SECONDS]      on the usual device; ALSOFT_DRIVERS=null for a machine without one
// Prints one CSV line.
#include <pthread.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "sound/audio_libraries.h"
#include "sound/openal_output.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

double seconds(const timespec& time) {
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double processorTime(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return seconds(time);
}

double processorTime(std::jthread& thread) {
    clockid_t clock{};
    pthread_getcpuclockid(thread.native_handle(), &clock);
    return processorTime(clock);
}

DrillSoundState cuttingAt(double time) {
    static const SoundCharacter materials[] = {soundCharacterOf("enamel"), soundCharacterOf("dentin"),
                                               soundCharacterOf("caries")};
    DrillSoundState state;
    state.speedRpm = 300000.0 + 60000.0 * std::sin(time);
    state.pedal = state.water = state.suction = 1.0;
    state.load = 0.4;
    state.removalWatt = 5.0 + 4.0 * std::sin(3.0 * time);
    state.material = materials[static_cast<std::size_t>(time) % 3];
    return state;
}

}  // namespace
}  // namespace tactooth

int main(int argc, char** argv) {
    using namespace tactooth;
    const double length = argc > 1 ? std::atof(argv[1]) : 600.0;
    prepareAudioLibraries();
    OpenAlOutput output;
    while (output.status() == SoundStatus::Starting) std::this_thread::sleep_for(1ms);
    if (output.status() != SoundStatus::Playing) {
        std::fputs("there is no sound card; set ALSOFT_DRIVERS=null to measure without one\n", stderr);
        return 2;
    }
    std::atomic<std::uint64_t> work{0};
    std::jthread busy([&](const std::stop_token& stop) {
        while (!stop.stop_requested()) work.fetch_add(1, std::memory_order_relaxed);
    });
    std::vector<float> latencies;
    latencies.reserve(static_cast<std::size_t>(1100 * length));
    const auto start = Clock::now();
    const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    const double usedBefore =
        processorTime(CLOCK_PROCESS_CPUTIME_ID) - processorTime(busy) - processorTime(CLOCK_THREAD_CPUTIME_ID);
    for (auto next = start; passed() < length; std::this_thread::sleep_until(next += 1ms)) {
        output.publish(cuttingAt(passed()));
        constexpr std::size_t kTicksPerPicture = 16;  // the window moves eye and bur 60 times a second
        if (latencies.size() % kTicksPerPicture == 0)
            output.setPlacement({{100.0 * std::sin(passed()), 0.0, -100.0}, {}});
        latencies.push_back(static_cast<float>(output.latency()));
    }
    const double used = processorTime(CLOCK_PROCESS_CPUTIME_ID) - processorTime(busy) -
                        processorTime(CLOCK_THREAD_CPUTIME_ID) - usedBefore;
    std::sort(latencies.begin(), latencies.end());
    const auto quantile = [&](double share) {
        return 1e3 * static_cast<double>(
                         latencies[static_cast<std::size_t>(share * static_cast<double>(latencies.size() - 1))]);
    };
    std::puts("seconds,blocks,underruns,core_percent,latency_p50_ms,latency_p99_ms,latency_max_ms");
    std::printf("%.0f,%llu,%llu,%.2f,%.1f,%.1f,%.1f\n", passed(),
                static_cast<unsigned long long>(output.playedBlocks()),
                static_cast<unsigned long long>(output.underruns()), 100.0 * used / passed(), quantile(0.5),
                quantile(0.99), quantile(1.0));
}
