// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/openhaptics/hd_driver.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>

#include "devices/base/device_presets.h"
#include "devices/base/messages.h"
#include "devices/base/monotonic_clock.h"
#include "devices/openhaptics/pen_names.h"

namespace tactooth {
namespace {

constexpr unsigned kStaleTicks = 2;  // driver ticks without a new force: the servo thread hangs, so none is rendered
constexpr unsigned kMotorCheckTicks = 100;  // ticks between two readings of the motors' temperature
constexpr unsigned kZeroForceTicks = 10;    // ticks in which a zero force is sent to a lost pen
constexpr unsigned kFaultTicks = 3000;      // ticks for which a transient fault is shown
constexpr int kMaxErrors = 16;              // in a tick: the list belongs to the driver and may be broken
constexpr double kCountFor = 0.01;          // s over which the driver's ticks are counted
constexpr double kMaxTimes = 4;  // times the requested rate; a driver that has stalled may catch up on some ticks
constexpr auto kRetry = std::chrono::seconds(1);
const Message kFlood(msg::kHdFlood);
const Message kDockPen(msg::kHdDockPen);

Message titleOf(const std::string& name) {
    return name.empty() ? Message(msg::kDefaultDevice) : Message(msg::kDeviceNamed, name);
}

std::string listOf(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

/// The reason why the pen `name` has not started. `code`: error code of the driver, 0 if it reports none. A driver may
/// report an unknown name as a link fault; the list of configured pens distinguishes the two cases.
Message whyNotStarted(const std::string& name, std::uint32_t code) {
    const bool mayBeUnknown = code == 0 || code == hd::kLinkFault || code == hd::kLinkSettings;
    const std::vector<std::string> pens = configuredPens();
    const std::string asked = name.empty() ? std::string(kDefaultPen) : name;
    if (mayBeUnknown && !pens.empty() && std::ranges::find(pens, asked) == pens.end())
        return {msg::kPenNotConfigured, titleOf(name), listOf(pens)};
    if (code != 0) return {msg::kPenFailed, titleOf(name), hdErrorMessage(code)};
    return {msg::kPenUnknown, titleOf(name)};
}

/// A motor's temperature from the driver's value, 0 cold .. 1 hot. NaN may mean anything, so it counts as hot. A value
/// out of range comes from a model that reports another quantity, so it counts as cold.
double motorTemperatureOf(double reported) {
    if (std::isnan(reported)) return 1;
    return reported >= 0 && reported <= 1 ? reported : 0;
}

/// The preset with the mechanics of a model. An unknown model gets that of the Touch, the one that needs most care.
const DevicePreset& presetFor(const std::string& model) {
    const bool fine = model.find("Touch X") != std::string::npos || model.find("Desktop") != std::string::npos ||
                      model.find("Premium") != std::string::npos;
    return *findDevicePreset(fine ? "touch-x" : "touch");
}

}  // namespace

Expected<std::shared_ptr<HdDriver>> HdDriver::shared(const std::string& library, double rateHz) {
    static std::mutex mutex;
    static std::weak_ptr<HdDriver> running;
    const std::lock_guard lock(mutex);
    if (auto driver = running.lock()) return driver;
    auto loaded = HdLibrary::load(library);
    if (!loaded) return Unexpected{loaded.error()};
    auto driver = std::make_shared<HdDriver>(std::move(*loaded), rateHz);
    running = driver;
    return driver;
}

HdDriver::HdDriver(std::shared_ptr<const HdLibrary> library, double rateHz)
    : library_(std::move(library)), call_(library_->call()), rateHz_(rateHz) {
    call_.setSchedulerRate(static_cast<unsigned long>(rateHz));
    maintenance_ = std::jthread([this](const std::stop_token& stop) { maintain(stop); });
}

HdDriver::~HdDriver() {
    maintenance_ = {};
    pause();
}

/// Stops the scheduler; no callback runs afterwards.
void HdDriver::pause() {
    if (!std::exchange(running_, false)) return;
    call_.stopScheduler();
    call_.unschedule(task_);
}

void HdDriver::resume() {
    if (std::ranges::none_of(pens_, &HdPen::active) || std::exchange(running_, true)) return;
    task_ = call_.schedule(&HdDriver::onTick, this, hd::kDefaultPriority);
    call_.startScheduler();
}

Expected<HdHandle> HdDriver::startDevice(const std::string& name) {
    while (call_.getError().code != 0) {
    }
    const HdHandle handle = call_.initDevice(name.empty() ? nullptr : name.c_str());
    const std::uint32_t code = call_.getError().code;
    if (code != 0 || handle > hd::kLargestHandle) return unexpected(whyNotStarted(name, code));
    call_.makeCurrent(handle);
    call_.enable(hd::kForceOutput);
    call_.enable(hd::kForceClamping);
    return handle;
}

void HdDriver::describe(HdPen& pen, DeviceInfo& info) {
    const char* const model = call_.getText(hd::kModel);
    const DevicePreset& preset = presetFor(model != nullptr ? model : "");
    info.name = model != nullptr && *model != 0 ? model : std::string(preset.title);
    if (!pen.name.empty()) info.name += " '" + pen.name + "'";
    double peak = 0;
    call_.getDoubles(hd::kMaxForce, &peak);
    double continuous = 0;
    call_.getDoubles(hd::kContinuousForce, &continuous);
    info.limits = limitsOf(preset, peak, continuous);
    std::array<double, 6> usable{};
    call_.getDoubles(hd::kUsableWorkspace, usable.data());
    info.workspace = Vec3(usable[3] - usable[0], usable[5] - usable[2], usable[4] - usable[1]);
    info.workspaceCentre = 0.5 * Vec3(usable[3] + usable[0], -usable[5] - usable[2], usable[4] + usable[1]);
    if (!info.workspace.allFinite() || info.workspace.minCoeff() <= 0) {
        info.workspace = preset.workspace;
        info.workspaceCentre.reset();
    }
    info.stiffness = preset.stiffness;
    info.rendersForce = info.sensesRotation = true;
    info.buttonCount = 2;
    call_.getIntegers(hd::kCalibrationStyle, &pen.calibrationStyle);
    while (call_.getError().code != 0) {  // a query that this model does not support is not a fault
    }
}

Expected<HdPen*> HdDriver::start(const std::string& name, DeviceInfo& info, const SampleListener& listener) {
    const std::lock_guard lock(mutex_);
    const auto pen = std::ranges::find(pens_, false, &HdPen::active);
    if (pen == pens_.end()) return unexpected(msg::kPensInUse);
    pause();
    const Expected<HdHandle> handle = startDevice(name);
    if (handle) {
        pen->listener = listener;
        pen->name = name;
        pen->handle = *handle;
        pen->ticks = pen->forceAge = pen->faultTicks = 0;
        pen->motorTemperature = 0;
        pen->calibrated = false;
        pen->faultMessage = nullptr;
        pen->lost = false;
        pen->force.write(Vec3::Zero());
        describe(*pen, info);
        pen->active = true;
    }
    resume();
    if (!handle) return Unexpected{handle.error()};
    return &*pen;
}

void HdDriver::stop(HdPen& pen) {
    const std::lock_guard lock(mutex_);
    pause();
    pen.active = false;
    sendZeroForce(pen);  // replaces the force of its last tick
    call_.disableDevice(pen.handle);
    resume();
}

std::uint32_t HdDriver::onTick(void* driver) {
    auto* const self = static_cast<HdDriver*>(driver);
    self->countTick();
    for (HdPen& pen : self->pens_) {
        if (!pen.active) continue;
        if (!pen.lost.load(std::memory_order_relaxed)) {
            self->exchange(pen);
        } else if (pen.zeroForcesLeft > 0) {
            self->sendZeroForce(pen);
        }
    }
    return kHdContinue;
}

/// Counts the ticks. Sets the rate fault when they come too often, and clears it after ten milliseconds at an
/// acceptable rate.
void HdDriver::countTick() {
    const double now = monotonicSeconds();
    ++counted_;
    const double passed = now - countedFrom_;
    const bool isTooMany = counted_ > kMaxTimes * rateHz_ * std::max(kCountFor, passed);
    rateFault_ = rateFault_ || isTooMany;
    if (passed < kCountFor) return;
    rateFault_ = isTooMany;
    countedFrom_ = now;
    counted_ = 0;
}

void HdDriver::exchange(HdPen& pen) {
    call_.makeCurrent(pen.handle);
    call_.beginFrame(pen.handle);
    HdReading reading;
    call_.getDoubles(hd::kTransform, reading.transform.data());
    std::int32_t buttons = 0;
    call_.getIntegers(hd::kButtons, &buttons);
    reading.buttons = static_cast<std::uint32_t>(buttons);
    const bool isTurn = pen.ticks++ % kMotorCheckTicks == 0;
    if (isTurn) monitorMotors(pen);
    monitorCalibration(pen, isTurn);
    pen.forceAge = pen.force.refresh() ? 0 : pen.forceAge + 1;
    const bool mayPush = pen.calibrated && !rateFault_ && pen.forceAge < kStaleTicks;
    const Vec3 force = mayPush ? pen.force.value() : Vec3::Zero();
    call_.setDoubles(hd::kForce, force.data());
    pen.forceActive.store(!force.isZero(0), std::memory_order_relaxed);
    call_.endFrame(pen.handle);
    takeErrors(pen);
    if (rateFault_) {
        pen.faultMessage.store(&kFlood);
        pen.faultTicks = kFaultTicks;
    }
    if (pen.lost.load(std::memory_order_relaxed)) sendZeroForce(pen);
    reading.motorTemperature = pen.motorTemperature;
    reading.calibrated = pen.calibrated && !rateFault_;
    reading.time = monotonicSeconds();
    pen.reading.write(reading);
    sem_post(&pen.ready);
    pen.listener();
}

/// A fault need not affect the motors: the library keeps the last force until it gets another one.
void HdDriver::sendZeroForce(HdPen& pen) {
    if (pen.zeroForcesLeft > 0) --pen.zeroForcesLeft;
    const Vec3 nothing = Vec3::Zero();
    call_.makeCurrent(pen.handle);
    call_.beginFrame(pen.handle);
    call_.setDoubles(hd::kForce, nothing.data());
    call_.endFrame(pen.handle);
    call_.disable(hd::kForceOutput);
    for (int i = 0; i < kMaxErrors && call_.getError().code != 0; ++i) {  // of a device that is gone; already reported
    }
}

void HdDriver::monitorMotors(HdPen& pen) {
    std::array<double, 6> temperature{};
    call_.getDoubles(hd::kMotorTemperature, temperature.data());
    pen.motorTemperature = 0;
    for (const double motor : temperature)
        pen.motorTemperature = std::max(pen.motorTemperature, motorTemperatureOf(motor));
}

/// Called at every tick: the position of a pen that has lost its calibration is not valid, so it must not cause a
/// force.
void HdDriver::monitorCalibration(HdPen& pen, bool mayUpdate) {
    const HdEnum state = call_.checkCalibration();
    if (mayUpdate && state == hd::kNeedsUpdate) call_.updateCalibration(static_cast<HdEnum>(pen.calibrationStyle));
    pen.calibrated = state == hd::kCalibrated;
    if (pen.calibrated) {
        const Message* docked = &kDockPen;
        pen.faultMessage.compare_exchange_strong(docked, nullptr);
    } else {
        pen.faultMessage.store(&kDockPen);
    }
}

void HdDriver::takeErrors(HdPen& pen) {
    if (pen.faultTicks > 0 && --pen.faultTicks == 0) pen.faultMessage.store(nullptr);
    for (int i = 0; i < kMaxErrors; ++i) {
        const std::uint32_t code = call_.getError().code;
        if (code == 0) return;
        pen.faultMessage.store(&hdErrorMessage(code));
        pen.faultTicks = kFaultTicks;
        if (code == hd::kWarmMotors) pen.motorTemperature = 1;
        if (!isHdErrorTransient(code) && !pen.lost.exchange(true)) {
            pen.zeroForcesLeft = kZeroForceTicks;
            pen.forceActive.store(false, std::memory_order_relaxed);
        }
    }
}

/// Starting a pen interrupts the driver's ticks, so it must not happen while another device renders a force.
bool HdDriver::isAnyForceActive() const {
    return std::ranges::any_of(pens_, [](const HdPen& pen) { return pen.active && !pen.lost && pen.forceActive; });
}

/// Tries periodically to restart lost pens.
void HdDriver::maintain(const std::stop_token& stop) {
    std::condition_variable_any wake;
    std::unique_lock lock(mutex_);
    while (!wake.wait_for(lock, stop, kRetry, [] { return false; }) && !stop.stop_requested()) {
        for (HdPen& pen : pens_) {
            if (!pen.active || !pen.lost.load() || isAnyForceActive()) continue;
            pause();
            call_.disableDevice(pen.handle);
            if (const Expected<HdHandle> handle = startDevice(pen.name)) {
                pen.handle = *handle;
                pen.calibrated = false;
                pen.ticks = pen.faultTicks = 0;
                pen.faultMessage.store(nullptr);
                pen.lost.store(false);
            }
            resume();
        }
    }
}

}  // namespace tactooth
