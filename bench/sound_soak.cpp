// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Plays a cut on the sound device in real time while one core is kept busy: does the sound ever run dry, how long is
// the way from a parameter to its sample, and what of a core does all of it take (OpenAL's mixer included)? A virtual
// machine may stand still as a whole: threads of real-time priority that only sleep show when it did, and a gap
// within 0.1 s of that is not the sound's own.
//   sound_soak [SECONDS]      on the usual device; ALSOFT_DRIVERS=null for a machine without one
// Prints one CSV line.
#include <pthread.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <numeric>
#include <thread>
#include <vector>

#include "haptics/cpu_latency_request.h"
#include "haptics/real_time.h"
#include "session/audio/material_sound.h"
#include "sound/output/audio_libraries.h"
#include "sound/output/openal_output.h"

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
    static const auto materials = [] {
        constexpr std::array kRoles = {MaterialRole::Enamel, MaterialRole::Dentin, MaterialRole::Decay};
        std::array<SoundCharacter, kRoles.size()> sounds;
        std::ranges::transform(kRoles, sounds.begin(), [](MaterialRole role) {
            return characterOf(MaterialTable(), builtinMaterials().withRole(role));
        });
        return sounds;
    }();
    DrillSoundState state;
    state.speedRpm = 300000.0 + 60000.0 * std::sin(time);
    state.pedal = state.water = state.suction = 1.0;
    state.load = 0.4;
    state.removalPower = 5.0 + 4.0 * std::sin(3.0 * time);
    state.material = materials[static_cast<std::size_t>(time) % materials.size()];
    return state;
}

/// One thread for each core sleeps for 1 ms at a time at real-time priority, and notes when it was woken late.
class StallMonitor {
public:
    StallMonitor() {
        for (unsigned core = 0; core < std::thread::hardware_concurrency(); ++core) {
            threads_.emplace_back([this, core](const std::stop_token& stop) { run(core, stop); });
        }
    }
    [[nodiscard]] bool stalled(Clock::time_point from, Clock::time_point to) const {
        const std::lock_guard lock(mutex_);
        return std::any_of(late_.begin(), late_.end(), [&](auto when) { return when >= from && when <= to; });
    }
    [[nodiscard]] std::size_t stops() const {
        const std::lock_guard lock(mutex_);
        return late_.size();
    }
    [[nodiscard]] double longest() const { return longest_; }
    [[nodiscard]] double used() {
        return std::accumulate(threads_.begin(), threads_.end(), 0.0,
                               [](double sum, std::jthread& thread) { return sum + processorTime(thread); });
    }

private:
    static constexpr double kLate = 0.005;  // s: a block of sound is 2.5 ms long, and two are always waiting
    void run(unsigned core, const std::stop_token& stop) {
        cpu_set_t cores;
        CPU_ZERO(&cores);
        CPU_SET(core, &cores);
        pthread_setaffinity_np(pthread_self(), sizeof cores, &cores);
        (void)acquireRealTimePriority();
        for (auto due = Clock::now() + 1ms; !stop.stop_requested(); due = Clock::now() + 1ms) {
            std::this_thread::sleep_until(due);
            const double late = std::chrono::duration<double>(Clock::now() - due).count();
            if (late < kLate) continue;
            const std::lock_guard lock(mutex_);
            longest_ = std::max(longest_, late);
            late_.push_back(Clock::now());
        }
    }

    mutable std::mutex mutex_;
    std::vector<Clock::time_point> late_;
    double longest_ = 0;  // s
    std::vector<std::jthread> threads_;
};

/// When the sound ran dry, as it is seen from outside.
class UnderrunLog {
public:
    void poll(const OpenAlOutput& output) {
        for (; seen_ < output.underruns(); ++seen_) gaps_.push_back(Clock::now());
    }
    [[nodiscard]] std::size_t ownUnderruns(const StallMonitor& machine) const {
        return static_cast<std::size_t>(std::count_if(gaps_.begin(), gaps_.end(), [&machine](auto when) {
            return !machine.stalled(when - 100ms, when + 100ms);
        }));
    }

private:
    std::uint64_t seen_ = 0;
    std::vector<Clock::time_point> gaps_;
};

}  // namespace
}  // namespace tactooth

int main(int argc, char** argv) {
    using namespace tactooth;
    const double length = argc > 1 ? std::atof(argv[1]) : 600.0;
    const CpuLatencyRequest asWhileAServoRuns;
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
    StallMonitor machine;
    UnderrunLog gaps;
    std::vector<float> latencies;
    latencies.reserve(static_cast<std::size_t>(1100 * length));
    const auto start = Clock::now();
    const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    const auto ownTime = [&] {
        return processorTime(CLOCK_PROCESS_CPUTIME_ID) - processorTime(busy) - machine.used() -
               processorTime(CLOCK_THREAD_CPUTIME_ID);
    };
    const double usedBefore = ownTime();
    for (auto next = start; passed() < length; std::this_thread::sleep_until(next += 1ms)) {
        output.publish(cuttingAt(passed()));
        constexpr std::size_t kTicksPerPicture = 16;  // the window moves eye and bur 60 times a second
        if (latencies.size() % kTicksPerPicture == 0)
            output.setPlacement({{100.0 * std::sin(passed()), 0.0, -100.0}, {}});
        latencies.push_back(static_cast<float>(output.latency()));
        gaps.poll(output);
    }
    std::this_thread::sleep_for(150ms);  // a stop that the last gap was due to may be noted later
    const double used = ownTime() - usedBefore;
    std::sort(latencies.begin(), latencies.end());
    const auto quantile = [&](double share) {
        return 1e3 * static_cast<double>(
                         latencies[static_cast<std::size_t>(share * static_cast<double>(latencies.size() - 1))]);
    };
    std::puts(
        "seconds,blocks,underruns,own_underruns,machine_stops,longest_stop_ms,core_percent,latency_p50_ms,"
        "latency_p99_ms,latency_max_ms");
    std::printf("%.0f,%llu,%llu,%zu,%zu,%.1f,%.2f,%.1f,%.1f,%.1f\n", passed(),
                static_cast<unsigned long long>(output.playedBlocks()),
                static_cast<unsigned long long>(output.underruns()), gaps.ownUnderruns(machine), machine.stops(),
                1e3 * machine.longest(), 100.0 * used / passed(), quantile(0.5), quantile(0.99), quantile(1.0));
}
