// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cut_timing.h"

#include <unistd.h>

#include <algorithm>
#include <deque>
#include <fstream>
#include <utility>

#include "experiments/quantile.h"
#include "experiments/thread_clock.h"
#include "geometry/util/parallel_for.h"
#include "haptics/tool_proxy.h"
#include "instruments/bur_shape.h"
#include "instruments/tool_trajectory.h"
#include "session/scripts/cut_run.h"
#include "session/scripts/softened_materials.h"

namespace tactooth {
namespace {

constexpr double kTick = ToolProxy::kTick;
constexpr double kRimSpeed = 300'000;     // rev/min: an air turbine that cuts
constexpr double kTurn = 20;              // degrees/s that the hand turns the bur, to and fro
constexpr double kMaxTurn = 5;            // degrees: a hand that mills a slot
constexpr double kRoundHeadLength = 0.8;  // diameters: where a round bur's neck begins

double residentMegabytes() {
    std::ifstream file("/proc/self/statm");
    double all = 0;
    double resident = 0;
    file >> all >> resident;
    return 1e-6 * resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// The four threads of a simulator, played one after the other on a clock of their own.
class CutTimingSimulation {
public:
    CutTimingSimulation(const std::shared_ptr<const LayeredTooth>& tooth, const CutCase& cut)
        : materials_(softenedMaterials(cut.removal)), model_(tooth, cut.voxel), voxel_(cut.voxel), cores_(cut.cores) {
        TriangleMesh bur = makeBur(cut.bur).surface;
        tool_.emplace(CuttingTool{std::move(*RevolutionEnvelope::make(bur)), cut.bur.sharpness});
        HapticSettings settings;
        settings.materials = materials_;
        settings.spindle = constantSpeed(kRimSpeed);
        simulation_.emplace(std::make_shared<const ToolShape>(std::move(bur)), tool_->envelope.maxRadius(),
                            model_.surface(), settings);
        simulation_->deferPlacement();
        surfaceBuilder_.emplace(simulation_->tool(), model_.contactSurface());
        newest_ = model_.surface();
        (void)model_.pool();
    }

    CutTiming run(std::span<const Pose> devicePath) {
        played_ = devicePath.size();
        for (std::size_t i = 0; i < devicePath.size(); ++i) play(static_cast<double>(i) * kTick, devicePath[i]);
        return result();
    }

private:
    void play(double now, const Pose& device) {
        while (!coming_.empty() && coming_.front().from <= now) useNewSurface(now);
        const double start = threadMicros();
        const Tick tick = simulation_->step({device, 1, true}, kTick);
        const double micros = threadMicros() - start;
        if (tick.contact.triangles > 0) tickMicros_.push_back(micros);
        timing_.deepest = std::max(timing_.deepest, tick.contact.depth);
        if (tick.contact.triangles > 0) working_.push_back(now);
        stepNeighbourLists(now, tick);
        stepCarving(now, tick);
        if (now >= prefetchFreeAt_) stepBrickPrefetch(now, tick);
    }

    /// The carving uses the new bricks from the next tick on: to make a few takes less than a tick.
    void stepBrickPrefetch(double now, const Tick& tick) {
        const double start = threadMicros();
        (void)model_.pool()->makeAround(tool_->envelope, tick.contact.proxy);
        const double took = threadMicros() - start;
        prefetchMicros_ += took;
        prefetchFreeAt_ = now + 1e-6 * took;
    }

    /// Carves for this tick as soon as the carve before is done.
    void stepCarving(double now, const Tick& tick) {
        const double begin = std::max(now, carvingFreeAt_);
        if (begin >= now + kTick) return;
        const auto millis = [this] { return cores_ > 1 ? wallMillis() : 1e-3 * threadMicros(); };
        const double start = millis();
        const bool changed = model_.feed(*tool_, tick, materials_);
        const double took = millis() - start;
        carvingMillis_ += took;
        carvingFreeAt_ = begin + 1e-3 * took;
        if (changed) {
            updateMillis_.push_back(took);
            cuts_.push_back({model_.surface(), *model_.reached(), carvingFreeAt_, begin, now});
            lastCutTick_ = now;
        } else {
            while (!working_.empty() && working_.back() > lastCutTick_) working_.pop_back();  // nothing comes of these
        }
    }

    /// Follows the tool at each tick, and builds a list for each cut.
    void stepNeighbourLists(double now, const Tick& tick) {
        if (neighbourListFreeAt_ <= now && (cuts_.empty() || cuts_.front().from > now)) {
            watch(now, tick);
            list(now, [&] {
                return tick.contact.placed ? surfaceBuilder_->rebuild()
                                           : surfaceBuilder_->place(newest_, tick.input.device);
            });
        }
        while (!cuts_.empty() && std::max(cuts_.front().from, neighbourListFreeAt_) < now + kTick) {
            const Cut cut = cuts_.front();
            cuts_.pop_front();
            if (!cuts_.empty() && cuts_.front().from <= neighbourListFreeAt_) continue;  // there is a newer one
            watch(now, tick);
            newest_ = cut.surface;
            newestCut_ = cut;
            list(std::max({now, cut.from, neighbourListFreeAt_}),
                 [&] { return surfaceBuilder_->make(cut.surface, tick.contact.proxy, cut.reached); });
        }
    }
    void watch(double now, const Tick& tick) {
        if (tick.contact.placed) surfaceBuilder_->watch(now, tick.contact.proxy, tick.diagnostics.ownListRebuilds);
    }
    template <class Make>
    void list(double begin, const Make& make) {
        const double start = threadMicros();
        HapticSurface* hapticSurface = make();
        const double took = 1e-3 * (threadMicros() - start);
        neighbourListFreeAt_ = begin + 1e-3 * took;
        if (hapticSurface == nullptr) return;
        coming_.push_back({hapticSurface, neighbourListFreeAt_, newestCut_.begun, newestCut_.tick});
        listMillis_.push_back(took);
    }

    void useNewSurface(double now) {
        const Coming coming = coming_.front();
        coming_.pop_front();
        simulation_->setSurface(*coming.hapticSurface);
        surfaceBuilder_->recycle(coming.hapticSurface);
        if (coming.cutBegun > touchedUpTo_) carvedMillis_.push_back(1e3 * (now - coming.cutBegun));
        touchedUpTo_ = std::max(touchedUpTo_, coming.cutBegun);
        while (!working_.empty() && working_.front() <= coming.cutTick) {
            touchMillis_.push_back(1e3 * (now - working_.front()));
            working_.pop_front();
        }
    }

    CutTiming result() {
        timing_.ticks = tickMicros_.size();
        timing_.updates = updateMillis_.size();
        timing_.firstUpdate = updateMillis_.empty() ? 0 : updateMillis_.front();
        timing_.largest = quantile(tickMicros_, 1);
        timing_.p50 = quantile(tickMicros_, 0.5);
        timing_.p99 = quantile(tickMicros_, 0.99);
        timing_.p999 = quantile(tickMicros_, 0.999);
        timing_.touchP50 = quantile(touchMillis_, 0.5);
        timing_.touchP99 = quantile(touchMillis_, 0.99);
        timing_.carvedP50 = quantile(carvedMillis_, 0.5);
        timing_.carvedP99 = quantile(carvedMillis_, 0.99);
        timing_.updateP50 = quantile(updateMillis_, 0.5);
        timing_.updateP99 = quantile(updateMillis_, 0.99);
        timing_.updateLargest = quantile(updateMillis_, 1);
        timing_.lists = listMillis_.size();
        timing_.listP50 = quantile(listMillis_, 0.5);
        timing_.updatesPerSecond = static_cast<double>(timing_.updates) / (kTick * static_cast<double>(timing_.ticks));
        timing_.prefetchShare = 1e-6 * prefetchMicros_ / (kTick * static_cast<double>(played_));
        timing_.removed = total(model_.removed());
        timing_.nanosPerVoxel = 1e6 * carvingMillis_ / (timing_.removed / (voxel_ * voxel_ * voxel_));
        timing_.brickMegabytes = 1e-6 * static_cast<double>(model_.bytes());
        timing_.residentMegabytes = residentMegabytes();
        return timing_;
    }

    MaterialTable materials_;
    CutModel model_;
    double voxel_;
    int cores_;
    std::optional<CuttingTool> tool_;
    std::optional<HapticSimulation> simulation_;
    std::optional<HapticSurfaceBuilder> surfaceBuilder_;

    // Times in s: when a result is ready, when its carve began, and the last tick that the carve includes.
    struct Cut {
        std::shared_ptr<const Surface> surface;
        Pose reached;
        double from = 0;
        double begun = 0;
        double tick = 0;
    };
    struct Coming {
        HapticSurface* hapticSurface;
        double from;
        double cutBegun;
        double cutTick;
    };
    std::deque<Cut> cuts_;  // without a neighbour list so far
    Cut newestCut_;         // that has a neighbour list
    std::shared_ptr<const Surface> newest_;
    std::deque<Coming> coming_;  // not used by the servo yet
    double carvingFreeAt_ = 0;   // s
    double neighbourListFreeAt_ = 0;
    double prefetchFreeAt_ = 0;
    double lastCutTick_ = 0;
    double touchedUpTo_ = 0;      // the beginning of the last carve whose surface the servo uses
    std::deque<double> working_;  // ticks whose cut is not in the surface that the servo uses

    std::vector<double> tickMicros_, touchMillis_, carvedMillis_, updateMillis_, listMillis_;
    double carvingMillis_ = 0;
    double prefetchMicros_ = 0;
    std::size_t played_ = 0;  // ticks
    CutTiming timing_;
};

}  // namespace

BurSpec roundBur(double diameter) {
    return {"round", "Round bur", {}, BurKind::Round, BurMaterial::Carbide, diameter, kRoundHeadLength * diameter,
            0,       6,           1};
}

CutTiming timeCutting(const std::shared_ptr<const LayeredTooth>& tooth, const CutCase& cut) {
    ToolTrajectory path;
    path.speed = cut.speed;
    path.press = cut.engagement * cut.bur.headLength;
    path.approach = 0.2;
    path.stroke = cut.stroke;
    path.strokes = cut.strokes;
    path.turn = kTurn;
    path.maxRotation = kMaxTurn;
    const std::vector<Pose> devicePath = toolTrajectory(tooth->outer()->mesh(), path);
    const ThreadLimit cores(static_cast<std::size_t>(cut.cores));
    return CutTimingSimulation(tooth, cut).run(devicePath);
}

}  // namespace tactooth
