// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/haply/haply_device.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>

#include "devices/base/device_presets.h"
#include "devices/base/kept_message.h"
#include "devices/base/messages.h"
#include "devices/base/monotonic_clock.h"
#include "devices/base/timed_wait.h"
#include "haptics/real_time.h"

namespace tactooth {
namespace {

constexpr double kConnectTimeout = 1;       // s to connect: the service is on this machine
constexpr double kLongestSilence = 0.0035;  // s: three answers are missing, so the device is lost; no force after 5 ms
constexpr double kLateAnswer = 0.003;       // s: after this time a zero force is sent without waiting for the answer
constexpr double kLateForce = 0.003;        // s without a new force: the servo thread hangs, so no force is rendered
constexpr double kBroken = 1;               // s without any answer: the connection is given up
constexpr double kPollTimeout = 0.02;       // s between two checks whether the thread has to stop
constexpr double kCloseTimeout = 0.2;       // s for the answer to the last zero force
constexpr double kShownFor = 3;             // s for which a transient fault is shown
constexpr double kReportDelay = 0.05;       // s: an answer that is this late is reported at once
constexpr double kRecoveryTime = 0.1;       // s after a surplus answer during which no answer is trusted
constexpr double kGripPeriod = 0.02;  // s: a VerseGrip is read about 50 times a second, independently of the arm's rate
constexpr auto kRetry = std::chrono::seconds(1);
constexpr int kGripButtons = 3;

const Message kSlow(msg::kHaplySlow);
const Message kTooManyAnswers(msg::kHaplyTooManyAnswers);
const Message kLost(msg::kHaplyLost);
const Message kNoAnswer(msg::kHaplyNoAnswer);

/// Receives a message of the handshake. A service that hangs up and one that is silent are different faults: a service
/// that takes and drops each new connection has not stopped answering.
Expected<void> receiveInTime(HaplyConnection& connection, std::string& text) {
    switch (connection.receive(text, kConnectTimeout)) {
        case HaplyConnection::ReceiveStatus::Message:
            return {};
        case HaplyConnection::ReceiveStatus::Broken:
            return unexpected(msg::kHaplyLost);
        case HaplyConnection::ReceiveStatus::Nothing:
            break;
    }
    return unexpected(msg::kHaplyNoAnswer);
}

}  // namespace

HaplyDevice::HaplyDevice(std::string device, std::string address)
    : wanted_(std::move(device)), address_(std::move(address)) {
    sem_init(&wake_, 0, 0);
    describe();
}

HaplyDevice::~HaplyDevice() {
    close();
    sem_destroy(&wake_);
}

std::string HaplyDevice::defaultAddress() {
    const char* const own = std::getenv("TACTOOTH_HAPLY");
    return own != nullptr && *own != 0 ? own : "localhost:10001";
}

void HaplyDevice::describe() {
    const DevicePreset& preset = *findDevicePreset("inverse3");
    info_.name = std::string(preset.title) + (names_.device.empty() ? "" : " " + names_.device);
    info_.rendersForce = true;
    info_.sensesRotation = !names_.grip.empty();
    info_.buttonCount = names_.grip.empty() ? 0 : kGripButtons;
    info_.limits = limitsOf(preset);
    info_.poseLimits.rotationPeriod = kGripPeriod;
    info_.workspace = preset.workspace;
    info_.stiffness = preset.stiffness;
}

/// Connects and finds the device. Called by the thread, or by open() before the thread exists.
Expected<std::unique_ptr<HaplyConnection>> HaplyDevice::handshake(const std::string& wanted) {
    auto link = HaplyConnection::open(address_, kConnectTimeout);
    if (!link) return link;
    std::string first;
    if (const Expected<void> answered = receiveInTime(**link, first); !answered) return Unexpected{answered.error()};
    const Expected<HaplyNames> names = findHaply(first, wanted);
    if (!names) return Unexpected{names.error()};
    const Expected<HaplyReading> reading = readHaply(first, *names);
    if (!reading) return Unexpected{reading.error()};
    if (!(*link)->send(haplyHandshake(names->device), kConnectTimeout)) return unexpected(msg::kHaplyLost);
    if (const Expected<void> answered = receiveInTime(**link, first); !answered) return Unexpected{answered.error()};
    names_ = *names;
    outstanding_ = 0;
    return link;
}

Expected<void> HaplyDevice::open() {
    close();
    auto link = handshake(wanted_);
    if (!link) return Unexpected{link.error()};
    connection_ = std::move(*link);
    describe();
    faultMessage_.store(nullptr);
    force_.write(Vec3::Zero());
    turn_ = Quat::Identity();
    surplusAnswerAt_ = -1;
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
    return {};
}

void HaplyDevice::close() {
    if (!thread_.joinable()) return;
    thread_ = {};
    // The thread has ended, and its last message may have carried a force. When the service answers this message, the
    // arm renders no force.
    if (connection_ && connection_->send(haplyForce(names_.device, Vec3::Zero()), kPollTimeout)) {
        const double end = monotonicSeconds() + kCloseTimeout;
        for (++outstanding_; outstanding_ > 0 && monotonicSeconds() < end; --outstanding_) {
            if (connection_->receive(text_, end - monotonicSeconds()) != HaplyConnection::ReceiveStatus::Message) break;
        }
    }
    connection_.reset();
}

void HaplyDevice::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "haply");  // name for debuggers and profilers
    (void)acquireRealTimePriority();              // without the privilege everything works, with more jitter
    std::mutex alone;
    std::condition_variable_any wake;
    while (!stop.stop_requested()) {
        if (exchange(stop)) continue;
        connection_.reset();
        std::unique_lock lock(alone);
        (void)wake.wait_for(lock, stop, kRetry, [] { return false; });
        if (stop.stop_requested()) return;
        auto link = handshake(names_.device);
        if (link) {
            connection_ = std::move(*link);
        } else {
            setFault(keptMessage(link.error()));
        }
    }
}

/// True if the servo thread produces a force in time.
bool HaplyDevice::waitForForce() {
    while (sem_trywait(&wake_) == 0) {  // forces that were written while an answer was pending
    }
    if (force_.refresh()) return true;
    waitForSemaphore(wake_, kLateForce);
    return force_.refresh();
}

/// Counts arrived answers; more answers than messages are a fault of the service.
void HaplyDevice::countAnswers(int answers) {
    outstanding_ -= answers;
    if (outstanding_ >= 0) return;
    outstanding_ = 0;
    surplusAnswerAt_ = monotonicSeconds();
    setFault(kTooManyAnswers);
}

bool HaplyDevice::isConnectionValid() const {
    return surplusAnswerAt_ < 0 || monotonicSeconds() - surplusAnswerAt_ > kRecoveryTime;
}

/// Takes the messages that have arrived since the last answer; false if the connection is broken.
bool HaplyDevice::drainPending() {
    int unasked = 0;
    const HaplyConnection::ReceiveStatus status = connection_->receivePending(text_, unasked);
    countAnswers(unasked);
    return status != HaplyConnection::ReceiveStatus::Broken;
}

/// Processes the answer that has just arrived, or a newer one that has arrived since; false if the connection is
/// broken.
bool HaplyDevice::receiveAnswers() {
    int answers = 1;
    const HaplyConnection::ReceiveStatus status = connection_->receivePending(text_, answers);
    countAnswers(answers);
    if (status == HaplyConnection::ReceiveStatus::Broken) return false;
    if (outstanding_ == 0) parseAnswer();
    return true;
}

/// Sends one message and waits for its answer; false if the connection is broken.
bool HaplyDevice::exchange(const std::stop_token& stop) {
    if (!connection_) return false;
    const bool isFresh = waitForForce();
    const bool isOpen = drainPending();
    const Vec3 force = isFresh && isConnectionValid() ? force_.value() : Vec3(Vec3::Zero());
    if (!isOpen || !connection_->send(haplyForce(names_.device, force), kBroken)) {
        setFault(kLost);
        return false;
    }
    ++outstanding_;
    switch (connection_->receive(text_, kLateAnswer)) {
        case HaplyConnection::ReceiveStatus::Message:
            if (receiveAnswers()) return true;
            break;
        case HaplyConnection::ReceiveStatus::Nothing:
            return waitForLateAnswer(stop);
        case HaplyConnection::ReceiveStatus::Broken:
            break;
    }
    setFault(kLost);
    return false;
}

/// Records a late answer at the time `now`, s. Each late answer ends the force; the user gets a message only if there
/// are many.
bool HaplyDevice::isRepeatedlyLate(double now) {
    std::rotate(lateAnswers_.begin(), lateAnswers_.begin() + 1, lateAnswers_.end());
    lateAnswers_.back() = now;
    return now - lateAnswers_.front() < 1;
}

/// Sends a zero force and waits: the device must not keep a force while its answer is late.
bool HaplyDevice::waitForLateAnswer(const std::stop_token& stop) {
    const double began = monotonicSeconds();
    if (isRepeatedlyLate(began)) setFault(kSlow);
    bool sound = connection_->send(haplyForce(names_.device, Vec3::Zero()), kBroken);
    ++outstanding_;
    while (sound && outstanding_ > 0 && monotonicSeconds() < began + kBroken && !stop.stop_requested()) {
        if (monotonicSeconds() > began + kReportDelay) setFault(kSlow);
        switch (connection_->receive(text_, kPollTimeout)) {
            case HaplyConnection::ReceiveStatus::Message:
                sound = receiveAnswers();
                break;
            case HaplyConnection::ReceiveStatus::Nothing:
                break;
            case HaplyConnection::ReceiveStatus::Broken:
                sound = false;
        }
    }
    if (sound && outstanding_ == 0) return true;
    setFault(sound ? kNoAnswer : kLost);
    return false;
}

/// Processes an answer.
void HaplyDevice::parseAnswer() {
    Expected<HaplyReading> reading = readHaply(text_, names_);
    if (!reading) {  // otherwise the servo thread would use the previous position until it is too old
        HaplyReading none;
        none.usable = false;
        none.time = monotonicSeconds();
        reading_.write(none);
        sampleListener()();
        return setFault(keptMessage(reading.error()));
    }
    reading->time = monotonicSeconds();
    if (reading->hasTurn) turn_ = reading->hand.rotation;
    reading->hand.rotation = turn_;  // a grip in sleep mode keeps its last rotation
    reading->usable &= isConnectionValid();
    reading_.write(*reading);
    sampleListener()();
    if (reading->faultMessage != nullptr) return setFault(*reading->faultMessage);
    clearOldFault();
}

void HaplyDevice::setFault(const Message& message) {
    faultMessage_.store(&message, std::memory_order_release);
    faultSetAt_ = monotonicSeconds();
}

/// Called when there is no fault: clears the message of a past fault after it was shown long enough to be read.
void HaplyDevice::clearOldFault() {
    if (faultSetAt_ > 0 && monotonicSeconds() - faultSetAt_ > kShownFor) {
        faultMessage_.store(nullptr, std::memory_order_relaxed);
        faultSetAt_ = 0;
    }
}

DeviceSample HaplyDevice::read(double /*elapsed*/) {
    const bool isFresh = reading_.refresh();
    const HaplyReading& reading = reading_.value();
    DeviceSample sample;
    sample.age = reading.time > 0 ? monotonicSeconds() - reading.time : 0;
    sample.connected = reading.usable && reading.time > 0 && sample.age <= kLongestSilence;
    sample.hand = reading.hand;
    sample.buttons = reading.buttons;
    sample.isFresh = isFresh;
    return sample;
}

void HaplyDevice::write(const SafeWrench& wrench) {
    force_.write(wrench.force());
    sem_post(&wake_);
}

const Message* HaplyDevice::faultMessage() const {
    if (const Message* const fault = faultMessage_.load(std::memory_order_acquire))
        return fault;  // acquire: the message behind the pointer must be visible too
    return HapticDevice::faultMessage();
}

}  // namespace tactooth
