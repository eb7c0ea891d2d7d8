// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/live/live_runner.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>

namespace tactooth {
namespace {

constexpr auto kPause = std::chrono::milliseconds(1);  // one tick: nothing new comes before
constexpr auto kRest = std::chrono::milliseconds(8);   // while the tool rests
constexpr double kRests = 0.2;                         // s without motion: the hand has put the tool down

constexpr auto kLongestFade = std::chrono::milliseconds(100);  // 20 N take 67 ms; a device that hangs gets no longer

/// Whether `time` has reached `next`, which then is a second later.
bool isDue(double& next, double time) {
    if (time < next) return false;
    next = time + 1;
    return true;
}

/// Detects a tool that was put down; then the threads check for work less often.
class IdleDetector {
public:
    [[nodiscard]] bool idle(const Tick& now) {
        if (now.contact.proxy.position != place_) place_ = now.contact.proxy.position, movedAt_ = now.time;
        return now.time > movedAt_ + kRests;
    }

private:
    Vec3 place_ = Vec3::Zero();  // position at the last motion
    double movedAt_ = 0;         // s
};

}  // namespace

LiveRunner::LiveRunner(std::shared_ptr<CutModel> piece, Instrument instrument, const HapticSettings& settings,
                       HapticDevice& device, TickListener onTick, double rateHz,
                       std::optional<DeviceRegistration> registration, HapticDevice* second,
                       const std::optional<SessionControls>& controls, std::shared_ptr<EventLanes> lanes)
    : model_(std::move(piece)),
      instrument_(std::move(instrument)),
      rateHz_(rateHz),
      device_(device),
      second_(second),
      onTick_(std::move(onTick)),
      lanes_(std::move(lanes)),
      feed_(*model_),
      servo_(instrument_, model_->contactSurface(), settings),
      devices_(device, second, registration),
      force_{settings.force},
      controls_(controls.value_or(SessionControls{.force = settings.force})),
      carving_(model_, instrument_, settings.materials),
      listing_(servo_.tool(), servo_.surface()) {
    std::function<void(double)> waitForTick;
    if (device.drivesServoRate()) waitForTick = [&device](double longest) { device.waitForTick(longest); };
    loop_ = std::make_unique<ServoLoop>(
        rateHz, [this](double elapsed) { servoTick(elapsed); }, std::move(waitForTick));
    feed_.setLoop(*loop_);
    carvingThread_ = std::jthread([this](const std::stop_token& stop) { runCarving(stop); });
    brickPrefetchThread_ =
        std::jthread([this, pool = model_->pool()](const std::stop_token& stop) { runBrickPrefetch(stop, *pool); });
    neighbourListThread_ = std::jthread([this](const std::stop_token& stop) { runNeighbourLists(stop); });
}

/// A force that ends within one tick is a kick, so the servo thread fades it out within the limit of the force rate.
void LiveRunner::fadeOut() {
    fadingOut_.store(true);
    const auto end = std::chrono::steady_clock::now() + kLongestFade;
    while (!silent_.load() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(kPause);
}

LiveRunner::~LiveRunner() {
    fadeOut();
    carvingThread_ = {};                                   // joins
    while (std::optional<Request> left = takeRequest()) {  // nobody carries out an edit any more
        if (auto* const wanted = std::get_if<std::promise<ToothSnapshot>>(&*left)) answer(*wanted);
    }
    brickPrefetchThread_ = {};
    neighbourListThread_ = {};  // joins; now no thread fills the queues
    loop_.reset();
    device_.write(SafeWrench());
    if (second_ != nullptr) second_->write(SafeWrench());
}

/// Swaps in new surfaces and returns how many. The old ones go back to the neighbour-list thread: to free one would
/// stall the servo thread.
std::uint32_t LiveRunner::takeSurfaces() {
    std::uint32_t taken = 0;
    for (HapticSurface* hapticSurface = nullptr; pendingSurfaces_.pop(hapticSurface); ++taken) {
        servo_.take(*hapticSurface);
        retiredSurfaces_.push(hapticSurface);
    }
    return taken;
}

void LiveRunner::setForce(const SessionControls& controls) {
    const ForceParameters wanted{controls.force, controls.forceScale, maxStiffnessAt(devices_.maxStiffness(), rateHz_)};
    if (wanted == force_) return;
    force_ = wanted;
    servo_.setForce(force_);
    if (lanes_) lanes_->servo(ForceEvent{force_});
}

void LiveRunner::servoTick(double elapsed) {
    const auto start = std::chrono::steady_clock::now();
    controls_.refresh();
    const SessionControls& controls = controls_.value();
    const std::uint32_t taken = takeSurfaces();

    devices_.read(elapsed, {controls.clutch, controls.motionScaling, controls.buttons, controls.depthStop.get(),
                            controls.guide.get()});
    setForce(controls);
    const double pedal = std::max(controls.pedal, devices_.pedal());
    const TickInput input =
        TickInput::of({devices_.turbine(), pedal, controls.cutting != devices_.cutToggled()}, elapsed_.next(elapsed));
    Tick tick = servo_.step(input);
    devices_.write(tick, controls.forceEnabled && !fadingOut_.load(std::memory_order_relaxed), elapsed);
    if (lanes_) {
        lanes_->servo(TickEvent{input, taken});
        if (isDue(nextTickHash_, tick.time)) lanes_->servo(TickHashEvent{servo_.hash()});
    }
    feed_.publishDevices(devices_.mirror(), devices_.forceState(), devices_.isAtWorkspaceLimit());
    silent_.store(devices_.isSilent(), std::memory_order_relaxed);

    tick.diagnostics.micros =
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
    tickForCarving_.write(tick);
    tickForNeighbourLists_.write(tick);
    feed_.publish(tick, 1e6 * devices_.age() + tick.diagnostics.micros);
    if (onTick_) onTick_(tick);
}

void LiveRunner::publishSurface() {
    CarvedSurface cut{model_->contactSurface(), model_->reached()};
    feed_.publish(*model_);
    {
        const std::lock_guard lock(publishedMutex_);
        surfaceToList_ = Publication{std::move(cut), ++published_};
    }
    cutAvailable_.notify_one();
}

void LiveRunner::request(Edit edit) {
    const std::lock_guard lock(requestMutex_);
    requested_.emplace_back(edit);
}

std::future<ToothSnapshot> LiveRunner::snapshot() {
    std::promise<ToothSnapshot> wanted;
    std::future<ToothSnapshot> result = wanted.get_future();
    const std::lock_guard lock(requestMutex_);
    requested_.emplace_back(std::move(wanted));
    return result;
}

std::optional<LiveRunner::Request> LiveRunner::takeRequest() {
    const std::lock_guard lock(requestMutex_);
    if (requested_.empty()) return std::nullopt;
    std::optional<Request> first(std::move(requested_.front()));
    requested_.pop_front();
    return first;
}

void LiveRunner::answer(std::promise<ToothSnapshot>& wanted) const {
    wanted.set_value(snapshotOf(model_->volume(), model_->removed()));
}

/// One turn of the carving thread. Returns true if the surface has changed.
bool LiveRunner::processModel() {
    if (std::optional<Request> request = takeRequest()) {
        if (auto* const wanted = std::get_if<std::promise<ToothSnapshot>>(&*request)) {
            answer(*wanted);
            return false;
        }
        const Edit edit = std::get<Edit>(*request);
        const bool changed = carving_.edit(edit);
        if (lanes_) lanes_->carving(EditEvent{edit, changed});
        return changed;
    }
    if (!tickForCarving_.refresh()) return false;
    const Tick& now = tickForCarving_.value();
    carvingPose_.write(now.input.cutting && now.spindle.speedRpm > 0 ? std::optional(now.contact.proxy) : std::nullopt);
    const bool changed = carving_.carve(now);
    if (!changed) feed_.publish(model_->loss());
    if (lanes_) {
        lanes_->carving(CarveEvent{now.number, changed});
        if (isDue(nextCarvingHash_, now.time)) lanes_->carving(CarvingHashEvent{carving_.hash()});
    }
    return changed;
}

void LiveRunner::runCarving(const std::stop_token& stop) {
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

void LiveRunner::runBrickPrefetch(const std::stop_token& stop, BrickPool& pool) {
    pthread_setname_np(pthread_self(), "brick-prefetch");  // for debuggers and profilers
    while (!stop.stop_requested()) {
        (void)carvingPose_.refresh();
        const std::optional<Pose>& at = carvingPose_.value();
        if (at && pool.makeAround(instrument_.cutting.envelope, *at) > 0) continue;
        std::this_thread::sleep_for(at ? kPause : kRest);
    }
}

/// Waits for a surface with new cuts. Its number is 0 if there is none: the tool may need a new list first.
LiveRunner::Publication LiveRunner::waitForSurface(const std::stop_token& stop, bool idle) {
    std::unique_lock lock(publishedMutex_);
    (void)cutAvailable_.wait_for(lock, stop, idle ? kRest : kPause, [this] { return surfaceToList_.has_value(); });
    return std::exchange(surfaceToList_, std::nullopt).value_or(Publication());
}

/// Takes back what the servo thread has used up, and returns how many.
std::uint32_t LiveRunner::recycleSurfaces() {
    return static_cast<std::uint32_t>(
        retiredSurfaces_.consume_all([this](HapticSurface* hapticSurface) { listing_.recycle(hapticSurface); }));
}

/// Sends a surface or a list to the servo thread; false if there is none, or if the queue is full: then the servo
/// thread needs no more.
bool LiveRunner::send(HapticSurface* hapticSurface) {
    if (hapticSurface == nullptr) return false;
    if (pendingSurfaces_.push(hapticSurface)) {
        listing_.sent();
        return true;
    }
    listing_.recycle(hapticSurface);
    return false;
}

/// It has a thread of its own because a cut takes longer than a list lasts.
void LiveRunner::runNeighbourLists(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "neighbour-list");
    IdleDetector watch;
    bool idle = false;
    while (!stop.stop_requested()) {
        Publication publication = waitForSurface(stop, idle);
        const bool isNewTick = tickForNeighbourLists_.refresh();
        const Tick& now = tickForNeighbourLists_.value();
        idle = watch.idle(now);
        if (publication.number == 0 && !isNewTick && !listing_.hasUnsent()) continue;
        const std::uint32_t recycled = recycleSurfaces();
        std::optional<CarvedSurface> cut;
        if (publication.number != 0) cut = std::move(publication.cut);
        const bool sent = send(listing_.turn(now, std::move(cut)));
        if (lanes_) lanes_->listing(ListEvent{now.number, publication.number, recycled, sent});
    }
}

}  // namespace tactooth
