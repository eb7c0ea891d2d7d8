// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A library with the binary interface of HDAPI and no device: a hand on a spring, its own scheduler, and faults that a
// test switches on.
#include "standin_hd.h"

#include "pen_record.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <deque>
#include <limits>
#include <mutex>
#include <thread>

namespace {

using tactooth::test::HdFault;
using Callback = std::uint32_t (*)(void*);
using Clock = std::chrono::steady_clock;

struct ErrorRecord {
    std::uint32_t code;
    std::int32_t internal;
    std::uint32_t device;
};

constexpr std::uint32_t kMaxPens = 2;
constexpr double kTick = 0.001;
constexpr double kMass = 2e-4, kSpring = 0.5, kDamper = 0.02;  // N*s^2/mm, N/mm, N*s/mm: a hand with the pen

struct Pen {
    bool started = false;
    bool makesForce = false;  // set by hdEnable
    std::array<double, 3> position{}, speed{}, force{};
};

std::mutex guard;  // protects all variables below
std::array<Pen, kMaxPens> pens;
std::deque<std::uint32_t> errors;
std::array<double, 3> wanted{};
int buttons = 0;
HdFault fault = HdFault::None;
Clock::time_point faultSince;
int faultyPen = -1;  // -1: all
bool calibrated = true;
long ticksSinceFault = 0, lastForceTick = 0;
double strongest = 0, strongestFaulty = 0;

std::uint32_t current = 0;
std::atomic<Callback> task{nullptr};
void* taskUser = nullptr;
std::atomic<long> tickCount{0};
std::atomic<int> startCount{0};
std::jthread scheduler;

double lengthOf(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

/// What a test in another process shares with this library; nullptr: no test does.
tactooth::test::PenRecord* recordOfTest() {
#ifdef _WIN32
    return nullptr;
#else
    static auto* const kRecord = tactooth::test::mapPenRecord(std::getenv("TACTOOTH_STANDIN_RECORD"));
    return kRecord;
#endif
}

/// Takes the hand's target from the record.
void followRecord() {
    const auto* const record = recordOfTest();
    if (record == nullptr) return;
    for (std::size_t i = 0; i < 3; ++i) wanted[i] = record->wanted[i].load();
}

/// Notes a force that goes to the motors.
void noteForce(double force) {
    auto* const record = recordOfTest();
    if (record == nullptr) return;
    const double now = std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
    if (force > 0) {
        record->zeroAt = 0;
    } else if (record->force > 0) {
        record->zeroAt = now;
    }
    record->force = force;
}

/// Notes which process holds the pen, and that it lives.
void noteTick() {
    auto* const record = recordOfTest();
    if (record == nullptr) return;
#ifndef _WIN32
    record->process = getpid();
#endif
    ++record->ticks;
}

void moveHands() {
    const std::lock_guard lock(guard);
    followRecord();
    noteTick();
    for (Pen& pen : pens) {
        for (std::size_t i = 0; i < 3; ++i) {
            const double push = pen.force[i] + kSpring * (wanted[i] - pen.position[i]) - kDamper * pen.speed[i];
            pen.speed[i] += kTick / kMass * push;
            pen.position[i] += kTick * pen.speed[i];
        }
    }
    const double force = lengthOf(pens[0].force);
    strongest = std::max(strongest, force);
    if (force > 0) lastForceTick = ticksSinceFault;
    // Also 5 ms by its own ticks: a machine that stalls keeps the force of the moment before.
    const bool isLate = Clock::now() - faultSince > std::chrono::milliseconds(5) && ticksSinceFault >= 5;
    if (fault != HdFault::None && isLate) strongestFaulty = std::max(strongestFaulty, force);
}

HdFault faultNow() {
    const std::lock_guard lock(guard);
    return fault;
}

void run(const std::stop_token& stop) {
    sched_param priority{};
    priority.sched_priority = 70;  // like a vendor's driver, if the system permits it
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
    auto due = Clock::now();
    while (!stop.stop_requested()) {
        due += faultNow() == HdFault::Flood ? std::chrono::microseconds(50) : std::chrono::milliseconds(1);
        std::this_thread::sleep_until(due);
        if (Clock::now() - due > std::chrono::milliseconds(20)) due = Clock::now();
        if (faultNow() == HdFault::Unplugged) {
            const std::lock_guard lock(guard);  // a pen without power has no force
            for (Pen& pen : pens) pen.force = {};
            continue;
        }
        moveHands();
        {
            const std::lock_guard lock(guard);
            ++ticksSinceFault;
        }
        if (const Callback callback = task.load()) (void)callback(taskUser);
        ++tickCount;
        if (faultNow() == HdFault::Stall) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            const std::lock_guard lock(guard);
            fault = HdFault::None;
        }
    }
}

void reset() {
    const std::lock_guard lock(guard);
    errors.clear();
    wanted = {};
    for (Pen& pen : pens) pen = Pen{pen.started, pen.makesForce, {}, {}, {}};
    buttons = 0;
    fault = HdFault::None;
    faultyPen = -1;
    calibrated = true;
    strongest = strongestFaulty = 0;
    ticksSinceFault = lastForceTick = 0;
}

void setFault(int number) {
    const std::lock_guard lock(guard);
    fault = static_cast<HdFault>(number);
    faultSince = Clock::now();
    strongestFaulty = 0;
    ticksSinceFault = lastForceTick = 0;
    calibrated = fault != HdFault::NeedsInkwell;
    errors.clear();
    if (fault == HdFault::TooMuchForce) errors.push_back(0x0201);
}

void setFaultyPen(int pen) {
    const std::lock_guard lock(guard);
    faultyPen = pen;
}

bool isFaulty(std::uint32_t pen) { return faultyPen < 0 || faultyPen == static_cast<int>(pen); }

void wantPosition(double x, double y, double z) {
    const std::lock_guard lock(guard);
    wanted = {x, y, z};
}

void setButtons(int down) {
    const std::lock_guard lock(guard);
    buttons = down;
}

void lastForce(double* xyz) {
    const std::lock_guard lock(guard);
    std::copy(pens[0].force.begin(), pens[0].force.end(), xyz);
}

double forceOf(int pen) {
    const std::lock_guard lock(guard);
    return lengthOf(pens.at(static_cast<std::size_t>(pen)).force);
}

double strongestForce() {
    const std::lock_guard lock(guard);
    return strongest;
}

double strongestWhileFaulty() {
    const std::lock_guard lock(guard);
    return strongestFaulty;
}

long ticks() { return tickCount.load(); }

long lastForceSinceFault() {
    const std::lock_guard lock(guard);
    return lastForceTick;
}

int schedulerStarts() { return startCount.load(); }

int startedPens() {
    const std::lock_guard lock(guard);
    return static_cast<int>(std::ranges::count(pens, true, &Pen::started));
}

void readTransform(double* out) {
    std::fill(out, out + 16, 0.0);
    out[0] = out[5] = out[10] = out[15] = 1;
    const Pen& pen = pens[std::min(current, kMaxPens - 1)];
    for (std::size_t i = 0; i < 3; ++i) out[12 + i] = pen.position[i];
    if (fault == HdFault::NanPose) out[13] = std::numeric_limits<double>::quiet_NaN();
    // To and fro: if the machine stalls at that moment, a single jump could be a quick motion of the hand.
    const bool isOdd = ticksSinceFault % 2 == 1;
    if (fault == HdFault::Jump && isOdd) out[12] += 50;
    if (fault == HdFault::Jitter && isOdd) out[12] += 4.9;
    if (fault == HdFault::Drift) out[12] += 3.0 * static_cast<double>(ticksSinceFault);
    if (fault == HdFault::BentAxes) out[1] = 0.4;
    if (fault == HdFault::FlippingTurn && isOdd) {
        out[0] = out[5] = 0;
        out[1] = 1;
        out[4] = -1;
    }
}

}  // namespace

extern "C" {

tactooth::test::HdStandinControl standinControl = {
    reset,          setFault,       setFaultyPen,         wantPosition, setButtons,          lastForce,
    forceOf,        strongestForce, strongestWhileFaulty, ticks,        lastForceSinceFault, startedPens,
    schedulerStarts};

std::uint32_t hdInitDevice(const char* name) {
    const std::lock_guard lock(guard);
    if (fault == HdFault::CrashAtStart) std::raise(SIGSEGV);
    if (fault == HdFault::InitError || fault == HdFault::DeviceFault) errors.push_back(0x0300);
    const std::uint32_t pen = name != nullptr && std::strcmp(name, "Left") == 0 ? 1 : 0;
    const bool isAway = fault == HdFault::Unplugged || fault == HdFault::ErrorFlood;
    if ((fault == HdFault::LinkFault && isFaulty(pen)) || isAway) errors.push_back(0x0302);
    if (fault == HdFault::InUse || pens[pen].started) errors.push_back(0x0301);
    if (fault == HdFault::GarbageHandle) return 0x7F3A9C10;
    if (name != nullptr && std::strcmp(name, "Left") != 0 && std::strcmp(name, "Right") != 0) return 0xFFFFFFFF;
    if (!errors.empty()) return 0xFFFFFFFF;
    pens[pen].started = true;
    current = pen;
    return pen;
}

void hdDisableDevice(std::uint32_t pen) {
    const std::lock_guard lock(guard);
    if (pen < kMaxPens) pens[pen].started = false;
}

void hdMakeCurrentDevice(std::uint32_t pen) { current = pen; }
void hdBeginFrame(std::uint32_t) {}

void hdEndFrame(std::uint32_t) {
    const std::lock_guard lock(guard);
    if (fault == HdFault::LinkFault && isFaulty(current)) errors.push_back(0x0302);
    if (fault == HdFault::DeviceFault && isFaulty(current)) errors.push_back(0x0300);
    if (fault == HdFault::ErrorFlood) errors.assign(1000, 0x0302);
    if (fault == HdFault::WarmMotors) errors.push_back(0x0200);
}

ErrorRecord hdGetError() {
    const std::lock_guard lock(guard);
    if (errors.empty()) return {0, 0, 0xFFFFFFFF};
    const std::uint32_t code = errors.back();  // newest first
    errors.pop_back();
    return {code, -1, current};
}

void switchForce(std::uint32_t what, bool on) {
    const std::lock_guard lock(guard);
    Pen& pen = pens[std::min(current, kMaxPens - 1)];
    if (what != 0x4000) return;
    pen.makesForce = on;
    if (!on) pen.force = {};
    if (!on && current == 0) noteForce(0);
}

void hdEnable(std::uint32_t what) { switchForce(what, true); }
void hdDisable(std::uint32_t what) { switchForce(what, false); }

void hdGetIntegerv(std::uint32_t what, std::int32_t* out) {
    const std::lock_guard lock(guard);
    if (what == 0x2000) *out = current == 0 ? buttons : 0;
    if (what == 0x2555) *out = 4;
}

void hdGetDoublev(std::uint32_t what, double* out) {
    const std::lock_guard lock(guard);
    if (what == 0x2052) readTransform(out);
    if (what == 0x2603) *out = fault == HdFault::Boast ? 50 : fault == HdFault::Weak ? 1 : 3.3;
    if (what == 0x2604) *out = fault == HdFault::Boast ? 40 : fault == HdFault::Weak ? 0.4 : 0.88;
    const double heat = fault == HdFault::NanHeat      ? std::numeric_limits<double>::quiet_NaN()
                        : fault == HdFault::WarmMotors ? 0.95
                                                       : 0.1;
    if (what == 0x2605) std::fill(out, out + 3, heat);
    constexpr std::array<double, 6> kUsableWorkspace = {-80, -55, -30, 80, 65, 40};
    if (what == 0x2551) std::copy(kUsableWorkspace.begin(), kUsableWorkspace.end(), out);
}

void hdSetDoublev(std::uint32_t what, const double* in) {
    const std::lock_guard lock(guard);
    if (what != 0x2700 || current >= kMaxPens || !pens[current].makesForce) return;
    std::copy(in, in + 3, pens[current].force.begin());
    if (current == 0) noteForce(lengthOf(pens[0].force));
}

const char* hdGetString(std::uint32_t what) { return what == 0x2501 ? "Touch (stand-in)" : ""; }

std::uint32_t hdCheckCalibration() {
    const std::lock_guard lock(guard);
    return calibrated ? 0x5000 : 0x5002;
}

void hdUpdateCalibration(std::uint32_t) {}

void hdStartScheduler() {
    ++startCount;
    scheduler = std::jthread(run);
}
void hdStopScheduler() { scheduler = {}; }
void hdSetSchedulerRate(unsigned long) {}

unsigned long hdScheduleAsynchronous(Callback callback, void* user, std::uint16_t) {
    taskUser = user;
    task = callback;
    return 1;
}

void hdUnschedule(unsigned long) { task = nullptr; }

}  // extern "C"
