// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/realtime_command.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/cli/runs/realtime_link.h"
#include "app/cli/runs/run_recording.h"
#include "app/cli/terminal/output.h"
#include "app/cli/terminal/timing_bars.h"
#include "app/common/exit_code.h"
#include "devices/simulated/simulated_device.h"
#include "geometry/mesh/triangle_mesh.h"
#include "haptics/overload_check.h"
#include "haptics/real_time.h"
#include "instruments/builtin_tooth.h"
#include "instruments/bur_shape.h"
#include "session/io/run_metadata.h"
#include "session/live/live_runner.h"
#include "session/live/live_stream.h"
#include "session/simulation/session_voxel.h"
#include "session/simulation/tooth_source.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kStroke = 1.0;       // mm to each side
constexpr double kStrokeTime = 0.25;  // s
constexpr double kSink = 1.5;         // mm by which the hand aims below the surface: about 1 N
constexpr double kLinkShare = 0.25;   // of the time of the run, for each of the two links

/// Comes down on the middle of the tooth, strokes to and fro, and lifts now and then.
std::vector<DeviceKeyframe> strokes(const Box3& box, double seconds) {
    const Vec3 middle = box.center();
    const auto at = [&](double time, double x, double z) {
        return DeviceKeyframe{time, {{Vec3(middle.x() + x, middle.y(), z), Quat::Identity()}, 1, 0, true}};
    };
    std::vector<DeviceKeyframe> script = {at(0, 0, box.max().z() + 2)};
    double time = 0.5;
    for (int i = 0; time < seconds; ++i, time += kStrokeTime) {
        const bool lifted = i % 12 == 0;
        script.push_back(at(time, i % 2 ? kStroke : -kStroke, lifted ? box.max().z() + 1 : box.max().z() - 2 * kSink));
    }
    return script;
}

/// Keeps cores busy during its lifetime.
class CpuLoad {
public:
    explicit CpuLoad(unsigned count) {
        for (unsigned i = 0; i < count; ++i) {
            threads_.emplace_back([](const std::stop_token& stop) {
                volatile double x = 1;
                while (!stop.stop_requested()) x = std::sqrt(x + 1);
            });
        }
    }

private:
    std::vector<std::jthread> threads_;
};

/// One row of the table. The first four are those of the run, the others those of a device's link.
struct Line {
    const char* key;
    const char* title;
    const char* head;  ///< the title as the head of a column
    const LatencyHistogram* histogram;
};
constexpr std::size_t kRunLines = 4;

void printTable(const RealtimeOptions& options, const LiveRunner& runner, std::span<const Line> lines,
                bool memoryLocked) {
    const RunMetadata facts = currentRunMetadata();
    print("machine:  {}\ncommit:   {}\ncommand:  {}\n", facts.machine, facts.commit, facts.command);
    print("A simulated hand touched and cut the built-in molar for {:.0f} s at {:.0f} Hz{}.\n", options.seconds,
          options.rateHz, options.load ? ", with all other cores busy" : "");
    print("Priority: {}; memory: {}; processors: {}.\n\n",
          runner.feed().isRealTime() ? "real-time (SCHED_FIFO)" : "ordinary", memoryLocked ? "locked" : "not locked",
          runner.feed().limitsCpuLatency() ? "kept from deep sleep" : "may sleep deeply");
    print("{:<34} {:>8} {:>8} {:>8} {:>9}\n", "us", "p50", "p99", "p99.9", "max");
    std::vector<TimingBars> bars, linkBars;
    for (const auto& [key, title, head, histogram] : lines) {
        (bars.size() < kRunLines ? bars : linkBars).push_back({head, histogram->counts()});
        print("{:<34} {:>8.1f} {:>8.1f} {:>8.1f} {:>9.1f}\n", title, histogram->quantile(0.5),
              histogram->quantile(0.99), histogram->quantile(0.999), histogram->largest());
    }
    print("\nHistograms: number of times in each octave, with bars on a logarithmic scale.\n{}", timingBars(bars));
    if (!linkBars.empty()) print("\n{}", timingBars(linkBars));
    const ServoTiming& timing = runner.feed().timing();
    const auto ticks = static_cast<double>(timing.ticks.load());
    const auto missed = static_cast<double>(timing.missed.load());
    print("\n{:.0f} ticks, {:.0f} deadlines missed ({:.3f} %).\n", ticks, missed,
          100 * missed / std::max(1.0, ticks + missed));
}

/// Upper edges and counts, one of each per octave.
Json binsOf(const LatencyHistogram& histogram) {
    Json bins = Json::array();
    for (const LatencyBin& bin : histogram.counts().octaves()) {
        bins.push_back({{"below_us", bin.upTo}, {"count", bin.count}});
    }
    return bins;
}

Json jsonOf(const RealtimeOptions& options, const LiveRunner& runner, std::span<const Line> lines, bool locked) {
    const RunMetadata facts = currentRunMetadata();
    Json json = {{"machine", facts.machine},
                 {"commit", facts.commit},
                 {"command", facts.command},
                 {"date", facts.date},
                 {"seconds", options.seconds},
                 {"rate_hz", options.rateHz},
                 {"load", options.load},
                 {"real_time_priority", runner.feed().isRealTime()},
                 {"memory_locked", locked},
                 {"light_sleep", runner.feed().limitsCpuLatency()},
                 {"ticks", runner.feed().timing().ticks.load()},
                 {"missed", runner.feed().timing().missed.load()},
                 {"heavy_scene", isOverloaded(runner.feed().timing(), options.rateHz)}};
    for (const auto& [key, title, head, histogram] : lines) {
        json[key] = {{"p50_us", histogram->quantile(0.5)},
                     {"p99_us", histogram->quantile(0.99)},
                     {"p999_us", histogram->quantile(0.999)},
                     {"max_us", histogram->largest()},
                     {"bins", binsOf(*histogram)}};
    }
    return json;
}

std::vector<Line> linesOf(const LiveRunner& runner) {
    const ServoTiming& timing = runner.feed().timing();
    return {{"period_jitter", "jitter of the period", "period jitter", &timing.jitter},
            {"tick", "computing time of a tick", "tick duration", &timing.tick},
            {"lateness", "wake-up latency", "wake-up latency", &timing.lateness},
            {"device_to_force", "from the reading to its force", "reading to force", &runner.feed().deviceToForce()}};
}

std::vector<Line> linesOf(const LinkTiming& link) {
    return {{"link_in_process", "a driver's sample to its force", "sample to force", &link.inProcess()},
            {"link_through_hand", "the same, through tactooth-hand", "through t.-hand", &link.throughHand()},
            {"link_added", "what tactooth-hand adds", "tactooth-hand adds", &link.added()}};
}

/// Prints advice if the loop was late.
void printAdvice(const ServoTiming& timing, double rateHz) {
    const std::string advice = overloadAdvice(timing, rateHz);
    if (!advice.empty()) print("{}\n", advice);
    const std::string hint = realTimeHint(realTimeRights());
    if (!hint.empty()) print("{}\n", hint);
}

}  // namespace

int runRealtime(const RealtimeOptions& options) {
    RunRecording recording;
    if (const auto opened = recording.open(options.record, options.seal); !opened) return reportError(opened.error());
    std::unique_ptr<LiveStream> stream;
    if (!options.stream.empty()) {
        auto opened = LiveStream::open(options.stream);
        if (!opened) return reportError(opened.error());
        stream = std::move(*opened);
    }
    LiveRunner::TickListener onTick;
    if (stream != nullptr) onTick = [&stream](const Tick& tick) { stream->write(tick); };
    const BuiltinTooth molar = makeBuiltinTooth(BuiltinToothKind::LowerFirstMolar);
    auto tooth = layeredTooth(molar);
    if (!tooth) return reportError(tooth.error());
    const BurSpec spec = findBur("57").value();
    const TriangleMesh bur = makeBur(spec).surface;
    auto cutting = makeCuttingTool(bur, spec.sharpness);
    if (!cutting) return reportError(cutting.error());
    const auto piece =
        std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*tooth)), kSessionVoxel);
    SimulatedDevice hand(*findDevicePreset("touch-x"), *findHandImpedance("nominal"),
                         strokes(boundingBox(molar.outer), options.seconds + 1));
    const bool locked = lockMemory();
    const CpuLoad busy(options.load ? std::max(1U, std::thread::hardware_concurrency()) - 1 : 0);
    const auto link = LinkTiming::measure(kLinkShare * options.seconds, options.rateHz);

    const Instrument instrument{std::make_shared<const ToolShape>(bur), std::move(*cutting), spec.edge()};
    if (const auto begun = recording.begin(*piece, std::string(molar.name)); !begun) return reportError(begun.error());
    SessionRecorder* const recorder = recording.recorder();
    auto runner = std::make_unique<LiveRunner>(
        piece, instrument, HapticSettings(), hand, onTick, options.rateHz, std::optional<DeviceRegistration>(), nullptr,
        std::nullopt,
        recorder != nullptr ? recorder->begin({instrument, HapticSettings()}) : std::shared_ptr<EventLanes>());
    std::vector<Tick> ticks;
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(options.seconds);
    SessionControls controls;
    const auto isOver = [&] { return recording.stop().stop_requested() || std::chrono::steady_clock::now() >= end; };
    for (bool cut = false; !isOver(); cut = true) {
        controls.cutting = cut;
        runner->setControls(controls);
        std::this_thread::sleep_for(std::chrono::duration<double>(std::min(0.5, options.seconds / 4)));
        ticks.clear();
        runner->feed().fetchTicks(ticks);
    }
    const ServoTiming& timing = runner->feed().timing();
    std::vector<Line> lines = linesOf(*runner);
    if (link) {
        const std::vector<Line> more = linesOf(**link);
        lines.insert(lines.end(), more.begin(), more.end());
    }
    if (options.json) {
        Json json = jsonOf(options, *runner, lines, locked);
        if (!link) json["link_error"] = link.error().message();
        print("{}\n", json.dump(1, ' ', false, Json::error_handler_t::replace));
    } else {
        printTable(options, *runner, lines, locked);
        if (!link) print("{}\n", link.error().message());
        printAdvice(timing, options.rateHz);
    }
    const auto all = static_cast<double>(timing.ticks + timing.missed);
    constexpr double kMaxMissed = 0.01;  // share of the deadlines: a hand notices more
    const int exitCode = static_cast<double>(timing.missed) > kMaxMissed * all ? kExitNegative : kExitOk;
    runner.reset();  // the recording ends with it
    if (const auto closed = recording.close(piece->hash()); !closed) return reportError(closed.error());
    return exitCode;
}

}  // namespace tactooth
