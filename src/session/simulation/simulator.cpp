// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/simulator.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>

namespace tactooth {
namespace {

constexpr auto kPause = std::chrono::milliseconds(1);  // a tick: there is nothing new before it
constexpr auto kRest = std::chrono::milliseconds(8);   // as long as the tool rests
constexpr double kRests = 0.2;                         // s without a move: the hand has put it down

constexpr auto kLongestFade = std::chrono::milliseconds(100);  // 20 N take 67 ms; a device that hangs has no more
constexpr double kPauseBetweenCuts = 0.4;  // s without contact: the bur was lifted, a new cut begins (mark for undo)

/// Whether a tool has been put down: looked at now and then, it needs no attention at every tick.
class RestWatch {
public:
    [[nodiscard]] bool rests(const Tick& now) {
        if (now.proxy.position != place_) place_ = now.proxy.position, movedAt_ = now.time;
        return now.time > movedAt_ + kRests;
    }

private:
    Vec3 place_ = Vec3::Zero();  // where the tool was when it moved last
    double movedAt_ = 0;         // s
};

}  // namespace

Simulator::Simulator(std::shared_ptr<WorkPiece> piece, Instrument instrument, const HapticSettings& settings,
                     HapticDevice& device, TickListener onTick, double rateHz, std::optional<Seat> seat,
                     HapticDevice* second, double fineness)
    : piece_(std::move(piece)),
      instrument_(std::move(instrument)),
      settings_(settings),
      rateHz_(rateHz),
      device_(device),
      second_(second),
      onTick_(std::move(onTick)),
      simulation_(instrument_.shape, instrument_.cutting.envelope.maxRadius(), piece_->felt(), settings),
      hands_(device, second, seat),
      controls_(SimulatorControls{.force = settings.force, .fineness = fineness}),
      surfaces_(simulation_.tool(), piece_->felt()),
      newest_(piece_->felt()),
      watchedSurface_(piece_->surface()),
      watchedLoss_(piece_->loss()) {
    simulation_.letOthersPlace();
    std::function<void(double)> pace;
    if (device.setsPace()) pace = [&device](double longest) { device.waitForTick(longest); };
    loop_ = std::make_unique<ServoLoop>(
        rateHz, [this](double elapsed) { servoTick(elapsed); }, std::move(pace));
    cutter_ = std::jthread([this](const std::stop_token& stop) { runCutter(stop); });
    maker_ = std::jthread([this, stock = piece_->stock()](const std::stop_token& stop) { runMaker(stop, *stock); });
    lister_ = std::jthread([this](const std::stop_token& stop) { runLister(stop); });
}

/// A force that ends within one tick is a kick: the servo takes it back as fast as any force may change.
void Simulator::fadeOut() {
    leaving_.store(true);
    const auto end = std::chrono::steady_clock::now() + kLongestFade;
    while (!silent_.load() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(kPause);
}

Simulator::~Simulator() {
    fadeOut();
    cutter_ = {};  // joins
    maker_ = {};
    lister_ = {};  // after this nobody fills the queues
    loop_.reset();
    device_.write(SafeWrench());
    if (second_ != nullptr) second_->write(SafeWrench());
}

/// Swaps in what has come. What was felt before goes back to the lister: to free it would stall the servo.
void Simulator::takeNewSurface() {
    FeltSurface* felt = nullptr;
    while (fresh_.pop(felt)) {
        simulation_.setSurface(*felt);
        returned_.push(felt);
    }
}

void Simulator::servoTick(double elapsed) {
    const auto start = std::chrono::steady_clock::now();
    controls_.refresh();
    const SimulatorControls& controls = controls_.value();
    takeNewSurface();
    simulation_.force().setOverrides(controls.force);
    simulation_.force().setScale(controls.forceScale);

    hands_.read(elapsed, {controls.clutch, controls.fineness, controls.buttons});
    mirrorForWatcher_.write(hands_.mirror());
    simulation_.force().setStiffest(stiffestAt(hands_.stiffest(), rateHz_));
    const double pedal = std::max(controls.pedal, hands_.pedal());
    Tick tick = simulation_.step({hands_.turbine(), pedal, controls.cutting != hands_.cutToggled()}, elapsed);
    hands_.write(tick, controls.forceEnabled && !leaving_.load(std::memory_order_relaxed), elapsed);
    forceState_.store(hands_.forceState(), std::memory_order_relaxed);
    handAtEnd_.store(hands_.isAtEnd(), std::memory_order_relaxed);
    silent_.store(hands_.isSilent(), std::memory_order_relaxed);

    tick.micros = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
    deviceToForce_.add(1e6 * hands_.age() + tick.micros);
    tickForCutter_.write(tick);
    tickForLister_.write(tick);
    ticksForWatcher_.push(tick);
    if (onTick_) onTick_(tick);
}

void Simulator::fetchTicks(std::vector<Tick>& ticks) {
    ticksForWatcher_.consume_all([&](const Tick& tick) { ticks.push_back(tick); });
}

std::shared_ptr<const Surface> Simulator::surface() const {
    const std::lock_guard lock(watched_);
    return watchedSurface_;
}

TaggedMesh Simulator::exported() const { return exportedMesh(*surface(), piece_->volume().lattice().spacing()); }

ToothLoss Simulator::loss() const {
    const std::lock_guard lock(watched_);
    return watchedLoss_;
}

void Simulator::publishSurface() {
    CutSurface cut{piece_->felt(), piece_->reached()};
    {
        const std::lock_guard lock(watched_);
        watchedSurface_ = piece_->surface();
        watchedLoss_ = piece_->loss();
        unlisted_ = std::move(cut);
    }
    cutCame_.notify_one();
    surfaceUpdates_.fetch_add(1, std::memory_order_relaxed);
}

std::vector<std::byte> Simulator::toothFile(const Provenance& provenance) const {
    const std::lock_guard lock(pieceInUse_);
    return toothFileBytes(*piece_, provenance);
}

bool Simulator::undoAsAsked() {
    bool changed = false;
    for (int left = undosRequested_.exchange(0); left > 0; --left) changed |= piece_->undo();
    lastCut_ = -std::numeric_limits<double>::infinity();  // what comes next is a cut of its own
    return changed;
}

bool Simulator::cutAsAsked() {
    const Tick& tick = tickForCutter_.value();
    if (tick.contacts > 0 && tick.speedRpm > 0 && tick.time > lastCut_ + kPauseBetweenCuts) piece_->mark();
    if (tick.contacts > 0 && tick.speedRpm > 0) lastCut_ = tick.time;
    return piece_->feed(instrument_.cutting, tick, settings_.materials);
}

/// One turn of the cutter. True if the surface has changed.
bool Simulator::workOnPiece() {
    const std::lock_guard lock(pieceInUse_);
    if (resetRequested_.exchange(false)) {
        piece_->reset();
        return true;
    }
    if (undosRequested_.load() > 0) return undoAsAsked();
    if (!tickForCutter_.refresh()) return false;
    const Tick& now = tickForCutter_.value();
    cuttingAt_.write(now.cutting && now.speedRpm > 0 ? std::optional(now.proxy) : std::nullopt);
    return (tickForCutter_.value().cutting && cutAsAsked()) || piece_->letFall(tickForCutter_.value());
}

void Simulator::runCutter(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "cutter");  // for debuggers and profilers
    RestWatch watch;
    while (!stop.stop_requested()) {
        if (workOnPiece()) {
            publishSurface();
        } else {
            std::this_thread::sleep_for(watch.rests(tickForCutter_.value()) ? kRest : kPause);
        }
    }
}

void Simulator::runMaker(const std::stop_token& stop, BrickStock& stock) {
    pthread_setname_np(pthread_self(), "maker");  // for debuggers and profilers
    while (!stop.stop_requested()) {
        (void)cuttingAt_.refresh();
        const std::optional<Pose>& at = cuttingAt_.value();
        if (at && stock.makeAround(instrument_.cutting.envelope, *at) > 0) continue;
        std::this_thread::sleep_for(at ? kPause : kRest);
    }
}

/// What the cutter has made since the last call, if that comes before the tool has moved on.
std::optional<Simulator::CutSurface> Simulator::waitForCut(const std::stop_token& stop, bool rests) {
    std::unique_lock lock(watched_);
    (void)cutCame_.wait_for(lock, stop, rests ? kRest : kPause, [this] { return unlisted_.has_value(); });
    return std::exchange(unlisted_, std::nullopt);
}

/// Hands a surface or a list to the servo; false if it has not taken the last ones yet.
bool Simulator::send(FeltSurface* felt) {
    if (fresh_.push(felt)) return true;
    surfaces_.giveBack(felt);
    return false;
}

/// Lists what is near the tool, in each new surface and wherever the tool goes, and finds a place for a tool whose hand
/// came into the tooth, before the servo would have to do so within a tick. On a thread of its own: a cut takes longer
/// than a list lasts.
void Simulator::runLister(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "lister");
    RestWatch watch;
    bool rests = false;
    std::optional<CutSurface> unsent;
    while (!stop.stop_requested()) {
        if (std::optional<CutSurface> cut = waitForCut(stop, rests)) {
            newest_ = cut->felt;
            unsent = std::move(cut);
        }
        returned_.consume_all([this](FeltSurface* felt) { surfaces_.giveBack(felt); });
        (void)tickForLister_.refresh();
        const Tick& now = tickForLister_.value();
        rests = watch.rests(now);
        if (now.placed) surfaces_.watch(now.time, now.proxy, now.ownLists);
        if (unsent) {
            if (send(surfaces_.make(unsent->felt, now.proxy, unsent->reached.value_or(now.proxy)))) unsent.reset();
        } else if (FeltSurface* felt = now.placed ? surfaces_.renew() : surfaces_.place(newest_, now.hand)) {
            (void)send(felt);  // what the servo does not take, it has no need of
        }
    }
}

}  // namespace tactooth
