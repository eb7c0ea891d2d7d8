// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/simulator.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>

namespace tactooth {
namespace {

constexpr auto kPause = std::chrono::milliseconds(1);  // one tick: nothing new comes before
constexpr auto kRest = std::chrono::milliseconds(8);   // while the tool rests
constexpr double kRests = 0.2;                         // s without motion: the hand has put the tool down

constexpr auto kLongestFade = std::chrono::milliseconds(100);  // 20 N take 67 ms; a device that hangs gets no longer
constexpr double kPauseBetweenCuts = 0.4;  // s without contact: the bur was lifted, a new cut begins (mark for undo)

/// Detects a tool that was put down; then the threads check for work less often.
class IdleDetector {
public:
    [[nodiscard]] bool idle(const Tick& now) {
        if (now.proxy.position != place_) place_ = now.proxy.position, movedAt_ = now.time;
        return now.time > movedAt_ + kRests;
    }

private:
    Vec3 place_ = Vec3::Zero();  // position at the last motion
    double movedAt_ = 0;         // s
};

}  // namespace

Simulator::Simulator(std::shared_ptr<CutModel> piece, Instrument instrument, const HapticSettings& settings,
                     HapticDevice& device, TickListener onTick, double rateHz,
                     std::optional<DeviceRegistration> registration, HapticDevice* second, double motionScaling)
    : model_(std::move(piece)),
      instrument_(std::move(instrument)),
      settings_(settings),
      rateHz_(rateHz),
      device_(device),
      second_(second),
      onTick_(std::move(onTick)),
      simulation_(instrument_.shape, instrument_.cutting.envelope.maxRadius(), model_->contactSurface(), settings),
      devices_(device, second, registration),
      controls_(SimulatorControls{.force = settings.force, .motionScaling = motionScaling}),
      surfaces_(simulation_.tool(), model_->contactSurface()),
      newest_(model_->contactSurface()),
      publishedSurface_(model_->surface()),
      publishedLoss_(model_->loss()) {
    simulation_.deferPlacement();
    std::function<void(double)> waitForTick;
    if (device.drivesServoRate()) waitForTick = [&device](double longest) { device.waitForTick(longest); };
    loop_ = std::make_unique<ServoLoop>(
        rateHz, [this](double elapsed) { servoTick(elapsed); }, std::move(waitForTick));
    carvingThread_ = std::jthread([this](const std::stop_token& stop) { runCarving(stop); });
    brickPrefetchThread_ =
        std::jthread([this, pool = model_->pool()](const std::stop_token& stop) { runBrickPrefetch(stop, *pool); });
    neighbourListThread_ = std::jthread([this](const std::stop_token& stop) { runNeighbourLists(stop); });
}

/// A force that ends within one tick is a kick, so the servo thread fades it out within the limit of the force rate.
void Simulator::fadeOut() {
    fadingOut_.store(true);
    const auto end = std::chrono::steady_clock::now() + kLongestFade;
    while (!silent_.load() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(kPause);
}

Simulator::~Simulator() {
    fadeOut();
    carvingThread_ = {};  // joins
    brickPrefetchThread_ = {};
    neighbourListThread_ = {};  // joins; now no thread fills the queues
    loop_.reset();
    device_.write(SafeWrench());
    if (second_ != nullptr) second_->write(SafeWrench());
}

/// Swaps in new surfaces. The old one goes back to the neighbour-list thread: to free it would stall the servo thread.
void Simulator::adoptNewSurface() {
    HapticSurface* hapticSurface = nullptr;
    while (pendingSurfaces_.pop(hapticSurface)) {
        simulation_.setSurface(*hapticSurface);
        retiredSurfaces_.push(hapticSurface);
    }
}

void Simulator::servoTick(double elapsed) {
    const auto start = std::chrono::steady_clock::now();
    controls_.refresh();
    const SimulatorControls& controls = controls_.value();
    adoptNewSurface();
    simulation_.force().setOverrides(controls.force);
    simulation_.force().setScale(controls.forceScale);

    devices_.read(elapsed, {controls.clutch, controls.motionScaling, controls.buttons});
    mirrorForObserver_.write(devices_.mirror());
    simulation_.force().setMaxStiffness(maxStiffnessAt(devices_.maxStiffness(), rateHz_));
    const double pedal = std::max(controls.pedal, devices_.pedal());
    Tick tick = simulation_.step({devices_.turbine(), pedal, controls.cutting != devices_.cutToggled()}, elapsed);
    devices_.write(tick, controls.forceEnabled && !fadingOut_.load(std::memory_order_relaxed), elapsed);
    forceState_.store(devices_.forceState(), std::memory_order_relaxed);
    deviceAtWorkspaceLimit_.store(devices_.isAtWorkspaceLimit(), std::memory_order_relaxed);
    silent_.store(devices_.isSilent(), std::memory_order_relaxed);

    tick.micros = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
    deviceToForce_.add(1e6 * devices_.age() + tick.micros);
    tickForCarving_.write(tick);
    tickForNeighbourLists_.write(tick);
    ticksForObserver_.push(tick);
    if (onTick_) onTick_(tick);
}

void Simulator::fetchTicks(std::vector<Tick>& ticks) {
    ticksForObserver_.consume_all([&](const Tick& tick) { ticks.push_back(tick); });
}

std::shared_ptr<const Surface> Simulator::surface() const {
    const std::lock_guard lock(publishedMutex_);
    return publishedSurface_;
}

TaggedMesh Simulator::exported() const { return exportedMesh(*surface(), model_->volume().lattice().spacing()); }

ToothLoss Simulator::loss() const {
    const std::lock_guard lock(publishedMutex_);
    return publishedLoss_;
}

void Simulator::publishSurface() {
    CarvedSurface cut{model_->contactSurface(), model_->reached()};
    {
        const std::lock_guard lock(publishedMutex_);
        publishedSurface_ = model_->surface();
        publishedLoss_ = model_->loss();
        surfaceToList_ = std::move(cut);
    }
    cutAvailable_.notify_one();
    surfaceUpdates_.fetch_add(1, std::memory_order_relaxed);
}

std::vector<std::byte> Simulator::toothFile(const Provenance& provenance) const {
    const std::lock_guard lock(modelMutex_);
    return toothFileBytes(*model_, provenance);
}

bool Simulator::processUndoRequest() {
    bool changed = false;
    for (int left = undosRequested_.exchange(0); left > 0; --left) changed |= model_->undo();
    lastCut_ = -std::numeric_limits<double>::infinity();  // the next cut gets a mark of its own
    return changed;
}

bool Simulator::processCutRequest() {
    const Tick& tick = tickForCarving_.value();
    if (tick.contacts > 0 && tick.speedRpm > 0 && tick.time > lastCut_ + kPauseBetweenCuts) model_->mark();
    if (tick.contacts > 0 && tick.speedRpm > 0) lastCut_ = tick.time;
    return model_->feed(instrument_.cutting, tick, settings_.materials);
}

/// One turn of the carving thread. Returns true if the surface has changed.
bool Simulator::processModel() {
    const std::lock_guard lock(modelMutex_);
    if (resetRequested_.exchange(false)) {
        model_->reset();
        return true;
    }
    if (undosRequested_.load() > 0) return processUndoRequest();
    if (!tickForCarving_.refresh()) return false;
    const Tick& now = tickForCarving_.value();
    carvingPose_.write(now.cutting && now.speedRpm > 0 ? std::optional(now.proxy) : std::nullopt);
    return (tickForCarving_.value().cutting && processCutRequest()) ||
           model_->removeDetachedPieces(tickForCarving_.value());
}

void Simulator::runCarving(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "carving");  // for debuggers and profilers
    IdleDetector watch;
    while (!stop.stop_requested()) {
        if (processModel()) {
            publishSurface();
        } else {
            std::this_thread::sleep_for(watch.idle(tickForCarving_.value()) ? kRest : kPause);
        }
    }
}

void Simulator::runBrickPrefetch(const std::stop_token& stop, BrickPool& pool) {
    pthread_setname_np(pthread_self(), "brick-prefetch");  // for debuggers and profilers
    while (!stop.stop_requested()) {
        (void)carvingPose_.refresh();
        const std::optional<Pose>& at = carvingPose_.value();
        if (at && pool.makeAround(instrument_.cutting.envelope, *at) > 0) continue;
        std::this_thread::sleep_for(at ? kPause : kRest);
    }
}

/// Waits for a new cut surface; returns nothing if the tool needs a new list first.
std::optional<Simulator::CarvedSurface> Simulator::waitForCutSurface(const std::stop_token& stop, bool idle) {
    std::unique_lock lock(publishedMutex_);
    (void)cutAvailable_.wait_for(lock, stop, idle ? kRest : kPause, [this] { return surfaceToList_.has_value(); });
    return std::exchange(surfaceToList_, std::nullopt);
}

/// Sends a surface or a list to the servo thread; false if the queue is full.
bool Simulator::send(HapticSurface* hapticSurface) {
    if (pendingSurfaces_.push(hapticSurface)) return true;
    surfaces_.recycle(hapticSurface);
    return false;
}

/// Builds neighbour lists for each new surface and along the path of the tool. It also finds a start pose for a tool
/// whose device entered the tooth, which the servo thread could not do within a tick. It has a thread of its own
/// because a cut takes longer than a list lasts.
void Simulator::runNeighbourLists(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "neighbour-list");
    IdleDetector watch;
    bool idle = false;
    std::optional<CarvedSurface> unsent;
    while (!stop.stop_requested()) {
        if (std::optional<CarvedSurface> cut = waitForCutSurface(stop, idle)) {
            newest_ = cut->surface;
            unsent = std::move(cut);
        }
        retiredSurfaces_.consume_all([this](HapticSurface* hapticSurface) { surfaces_.recycle(hapticSurface); });
        (void)tickForNeighbourLists_.refresh();
        const Tick& now = tickForNeighbourLists_.value();
        idle = watch.idle(now);
        if (now.placed) surfaces_.watch(now.time, now.proxy, now.ownListRebuilds);
        if (unsent) {
            if (send(surfaces_.make(unsent->surface, now.proxy, unsent->reached.value_or(now.proxy)))) unsent.reset();
        } else if (HapticSurface* hapticSurface =
                       now.placed ? surfaces_.rebuild() : surfaces_.place(newest_, now.hand)) {
            (void)send(hapticSurface);  // a full queue means that the servo thread needs no more
        }
    }
}

}  // namespace tactooth
