// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/hand_supervisor.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <utility>

#include "devices/base/kept_message.h"
#include "devices/base/monotonic_clock.h"
#include "devices/process/messages.h"
#include "geometry/files/file_bytes.h"
#include "haptics/real_time.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;

constexpr double kOpenTimeout = 30;   // s: a driver takes some seconds to find its device, and is tried before
constexpr auto kOpenCheck = 2ms;      // between two checks whether the device is open
constexpr auto kEndCheck = 5ms;       // between two checks whether the process has ended
constexpr auto kEndTimeout = 1500ms;  // for the process to close its device; then it is ended
constexpr auto kRetry = 1s;
constexpr double kHealthyAfter = 10;  // s of work after which earlier failures do not count

/// How a process has ended, in a few words.
Message wordsOf(const HandEnd& end) {
    if (end.cause == HandFault::HandKilled) return {msg::kHandSignal, strsignal(end.number)};
    return textOf(end.cause);
}

/// Why a process has not opened its device.
Error openError(const HandEnd& end, const HandLink& link, const HandRequest& request) {
    const bool hasFailed = link.status.load(std::memory_order_acquire) == HandStatus::Failed;
    if (const auto why = hasFailed ? messageFrom(link.failure) : std::nullopt) return {*why};
    const bool isOther = end.cause == HandFault::HandEnded && end.number == HandArguments::kOtherVersion;
    if (isOther) return {msg::kHandOtherVersion, displayName(request.program)};
    return {msg::kHandEndsAtStart, wordsOf(end)};
}

bool isOpen(const HandLink* link) {
    return link != nullptr && link->status.load(std::memory_order_acquire) == HandStatus::Open;
}

}  // namespace

HandSupervisor::HandSupervisor(HandRequest request) : request_(std::move(request)) {}

HandSupervisor::~HandSupervisor() { stop(); }

const Message* HandSupervisor::faultMessage() const {
    return isOpen(link()) ? nullptr : faultMessage_.load(std::memory_order_acquire);
}

Expected<void> HandSupervisor::start() {
    stop();
    failures_ = 0;
    hasOpened_ = hasFinished_ = false;
    firstError_.reset();
    faultMessage_.store(nullptr);
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
    const auto end = secondsFromNow(kOpenTimeout);
    std::unique_lock lock(mutex_);
    while (!isOpen(link()) && !firstError_ && MonotonicClock::now() < end) changed_.wait_for(lock, kOpenCheck);
    hasOpened_ = isOpen(link());
    if (hasOpened_) return {};
    const Error error = firstError_.value_or(Error(msg::kHandOpensTooLong, static_cast<int>(kOpenTimeout)));
    lock.unlock();
    stop();
    return Unexpected{error};
}

void HandSupervisor::stop() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    const auto end = MonotonicClock::now() + kEndTimeout;
    std::unique_lock lock(mutex_);
    while (!hasFinished_) {
        if (HandLink* const current = link()) {
            current->endRequested.store(1);
            current->handBell.ring();
        }
        if (process_ && MonotonicClock::now() > end) process_->kill();
        changed_.wait_for(lock, kEndCheck);
    }
    lock.unlock();
    thread_.join();
    thread_ = {};
    memories_.clear();
}

void HandSupervisor::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "hand-supervise");  // name for debuggers and profilers
    (void)acquireRealTimePriority();                       // it ends a process that is stopped, within a few ms
    while (!stop.stop_requested() && runOnce(stop)) {
        std::unique_lock lock(mutex_);
        (void)changed_.wait_for(lock, stop, kRetry, [] { return false; });
    }
    const std::lock_guard lock(mutex_);
    hasFinished_ = true;
    changed_.notify_all();
}

Expected<HandLink*> HandSupervisor::startProcess(const std::stop_token& stop) {
    const std::lock_guard lock(mutex_);
    Expected<HandMemory> memory = HandMemory::create();
    if (!memory) return Unexpected{memory.error()};
    memories_.push_back(std::move(*memory));
    auto process = HandProcess::start(request_, memories_.back());
    if (!process) return Unexpected{process.error()};
    process_ = std::move(*process);
    processId_.store(process_->id(), std::memory_order_relaxed);
    HandLink& link = memories_.back().link();
    link.endRequested.store(stop.stop_requested() ? 1 : 0);
    link_.store(&link, std::memory_order_release);
    return &link;
}

void HandSupervisor::forgetProcess(HandLink& link) {
    const std::lock_guard lock(mutex_);
    link_.store(nullptr, std::memory_order_release);
    processId_.store(0, std::memory_order_relaxed);
    process_.reset();
    changed_.notify_all();
    link.programBell.ring();
}

/// Keeps an error for start(), or for people while the device is open. Returns whether to try again.
bool HandSupervisor::fail(const Error& error) {
    faultMessage_.store(&keptMessage(error), std::memory_order_release);
    const std::lock_guard lock(mutex_);
    if (!hasOpened_) firstError_ = error;
    changed_.notify_all();
    return hasOpened_;
}

/// Runs one process to its end. Returns whether to try again.
bool HandSupervisor::runOnce(const std::stop_token& stop) {
    const double startedAt = monotonicSeconds();
    const Expected<HandLink*> started = startProcess(stop);
    if (!started) return fail(started.error());
    HandLink& link = **started;
    const HandEnd end = process_->wait();
    forgetProcess(link);
    if (stop.stop_requested()) return false;
    if (!isOpen(&link)) {
        ++failures_;
        if (!fail(openError(end, link, request_))) return false;
    } else {
        failures_ = monotonicSeconds() - startedAt > kHealthyAfter ? 1 : failures_ + 1;
        if (!fail({msg::kHandIsGone, wordsOf(end)})) return false;
        const auto& name = link.description.name;  // perhaps without a zero at its end: the process may be broken
        const std::string device(name.begin(), std::ranges::find(name, '\0'));
        (void)appendFault(request_.faultLog, {std::chrono::system_clock::now(), end.cause, device, 0, 0});
    }
    if (failures_ <= kMaxRestarts) return true;
    (void)fail({msg::kHandIsGivenUp, failures_, wordsOf(end)});
    return false;
}

}  // namespace tactooth
