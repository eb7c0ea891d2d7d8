// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// How fast recordings are simulated again, and how soon any moment of them is there: replay_bench FILE... [--jumps N].
// Makes the track of each as the window does, then jumps to random moments. Prints a table.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <random>
#include <string_view>
#include <vector>

#include "geometry/util/number_text.h"
#include "session/track/make_track.h"
#include "session/track/track_tooth.h"

namespace tactooth {
namespace {

/// Elapsed and processor time of all threads since its construction, s.
class Watch {
public:
    [[nodiscard]] double elapsed() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    [[nodiscard]] double processor() const {
        return static_cast<double>(std::clock() - clock_) / static_cast<double>(CLOCKS_PER_SEC);
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::clock_t clock_ = std::clock();
};

/// Both times of a jump, s.
struct Jumps {
    std::vector<double> elapsed, processor;
};

Jumps jump(const std::shared_ptr<const SessionTrack>& track, int count) {
    std::mt19937 random(1);
    std::uniform_int_distribution<std::uint64_t> anyMoment(0, track->ticks());
    TrackTooth tooth(track);
    Jumps jumps;
    for (int i = 0; i < count; ++i) {
        const Watch watch;
        tooth.moveTo(anyMoment(random));
        if (tooth.model().surface() == nullptr) std::abort();  // what the picture waits for
        jumps.elapsed.push_back(watch.elapsed());
        jumps.processor.push_back(watch.processor());
    }
    return jumps;
}

std::string quantiles(std::vector<double> seconds) {
    std::ranges::sort(seconds);
    const auto at = [&](double share) {
        return 1000 * seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1))];
    };
    return fmt::format("p50 {:.0f} ms, p95 {:.0f} ms, longest {:.0f} ms", at(0.5), at(0.95), at(1));
}

Expected<void> measure(const std::filesystem::path& file, int jumps) {
    const Expected<SessionRecording> recording = SessionRecording::open(file);
    if (!recording) return Unexpected{recording.error()};
    Expected<std::shared_ptr<CutModel>> model = recording->makeModel();
    if (!model) return Unexpected{model.error()};
    Expected<std::shared_ptr<SessionTrack>> track = emptyTrack(*recording, **model);
    if (!track) return Unexpected{track.error()};
    const Watch watch;
    makeTrack(*recording, std::move(*model), **track);
    const double elapsed = watch.elapsed(), processor = watch.processor(), seconds = (*track)->seconds();
    fmt::print("{}: {:.1f} s, {} ticks, {}\n", file.filename().string(), seconds, (*track)->ticks(),
               (*track)->differsAt() || (*track)->fault() ? "DIFFERS" : "the recorded numbers");
    fmt::print("  replay       {:.1f} times real time elapsed ({:.1f} s), {:.1f} times by processor time ({:.1f} s)\n",
               seconds / elapsed, elapsed, seconds / processor, processor);
    fmt::print("  track        {:.1f} MB\n", 1e-6 * static_cast<double>((*track)->bytes()));
    if ((*track)->ticks() == 0 || jumps == 0) return {};
    const Jumps times = jump(*track, jumps);
    fmt::print("  {} jumps    {} elapsed\n", jumps, quantiles(times.elapsed));
    fmt::print("               {} of processor time\n", quantiles(times.processor));
    return {};
}

}  // namespace
}  // namespace tactooth

int main(int argc, char** argv) {
    int jumps = 200;
    std::vector<std::filesystem::path> files;
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]) != "--jumps") {
            files.emplace_back(argv[i]);
        } else if (const auto count = i + 1 < argc ? tactooth::toNumber<int>(argv[i + 1]) : std::nullopt;
                   count && *count >= 0) {
            jumps = *count;
            ++i;
        } else {
            fmt::print(stderr, "--jumps takes a number from 0 on.\n");
            return 2;
        }
    }
    if (files.empty()) {
        fmt::print(stderr, "usage: replay_bench FILE.ttsession... [--jumps N]\n");
        return 2;
    }
    for (const auto& file : files) {
        if (const auto measured = tactooth::measure(file, jumps); !measured) {
            fmt::print(stderr, "{}\n", measured.error().message());
            return 2;
        }
    }
}
