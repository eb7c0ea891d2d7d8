// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/haply/haply_device.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <set>

#include "devices/device_presets.h"
#include "devices/monotonic_clock.h"
#include "devices/timed_wait.h"
#include "haptics/real_time.h"

namespace tactooth {
namespace {

constexpr double kPatience = 1;             // s to connect: the service is on this machine
constexpr double kLongestSilence = 0.0035;  // s: three answers were left out, so the device is lost; limp within 5 ms
constexpr double kLateAnswer = 0.003;       // s: from then on a zero force is sent without waiting for the answer
constexpr double kLateForce = 0.003;        // s without a new force: the servo hangs, so nothing is rendered
constexpr double kBroken = 1;               // s without any answer: the connection is given up
constexpr double kGlance = 0.02;            // s between two looks at whether the program wants to end
constexpr double kFarewell = 0.2;           // s for the answer to the last zero
constexpr double kShownFor = 3;             // s that a passing trouble is shown
constexpr double kToldAfter = 0.05;         // s: an answer that is so late is told at once
constexpr double kDistrust = 0.1;           // s after an answer too many that no answer is believed
constexpr double kGripPeriod = 0.02;        // s: a VerseGrip is read some 50 times a second, whatever the arm is
constexpr auto kRetry = std::chrono::seconds(1);
constexpr int kGripButtons = 3;

constexpr const char* kSlow =
    "The Haply Inverse Service answers too slowly: close other programs that keep this machine busy.";
constexpr const char* kSurplus =
    "The Haply Inverse Service sends more answers than it is asked for, so the force is off: restart the service.";
constexpr const char* kLost =
    "The Haply Inverse Service has closed the connection: start it again; it is tried again every second.";
constexpr const char* kMute =
    "The Haply Inverse Service has stopped answering: restart it; it is tried again every second.";

/// A sentence that stays as long as the program; there are few different ones.
const char* kept(const std::string& sentence) {
    static std::mutex mutex;
    static std::set<std::string> sentences;
    const std::lock_guard lock(mutex);
    return sentences.insert(sentence).first->c_str();
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

std::string HaplyDevice::usualAddress() {
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
    info_.poseLimits.turnPeriod = kGripPeriod;
    info_.workspace = preset.workspace;
    info_.stiffness = preset.stiffness;
}

/// Connects and finds out who is there. The thread's, or open()'s before there is one.
Expected<std::unique_ptr<HaplyLink>> HaplyDevice::meet(const std::string& wanted) {
    auto link = HaplyLink::open(address_, kPatience);
    if (!link) return link;
    std::string first;
    if ((*link)->receive(first, kPatience) != HaplyLink::Heard::Message) return unexpected(kMute);
    const Expected<HaplyNames> names = findHaply(first, wanted);
    if (!names) return Unexpected{names.error()};
    const Expected<HaplyReading> reading = readHaply(first, *names);
    if (!reading) return Unexpected{reading.error()};
    if (!(*link)->send(haplyGreeting(names->device), kPatience) ||
        (*link)->receive(first, kPatience) != HaplyLink::Heard::Message) {
        return unexpected(kMute);
    }
    names_ = *names;
    owed_ = 0;
    return link;
}

Expected<void> HaplyDevice::open() {
    close();
    auto link = meet(wanted_);
    if (!link) return Unexpected{link.error()};
    link_ = std::move(*link);
    describe();
    trouble_.store(nullptr);
    force_.write(Vec3::Zero());
    turn_ = Quat::Identity();
    surplusAt_ = -1;
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
    return {};
}

void HaplyDevice::close() {
    if (!thread_.joinable()) return;
    thread_ = {};
    // The thread is gone, and what it said last may have been a force: with the answer to this the arm is limp.
    if (link_ && link_->send(haplyForce(names_.device, Vec3::Zero()), kGlance)) {
        const double end = monotonicSeconds() + kFarewell;
        for (++owed_; owed_ > 0 && monotonicSeconds() < end; --owed_) {
            if (link_->receive(text_, end - monotonicSeconds()) != HaplyLink::Heard::Message) break;
        }
    }
    link_.reset();
}

void HaplyDevice::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "haply");  // for debuggers and profilers
    (void)takeRealTimePriority();                 // without the right to it everything works, with more jitter
    std::mutex alone;
    std::condition_variable_any wake;
    while (!stop.stop_requested()) {
        if (exchange(stop)) continue;
        link_.reset();
        std::unique_lock lock(alone);
        (void)wake.wait_for(lock, stop, kRetry, [] { return false; });
        if (stop.stop_requested()) return;
        auto link = meet(names_.device);
        if (link) {
            link_ = std::move(*link);
        } else {
            complain(kept(link.error().message));
        }
    }
}

/// True if the servo makes a force in time.
bool HaplyDevice::waitForForce() {
    while (sem_trywait(&wake_) == 0) {  // forces that were made while an answer was on its way
    }
    if (force_.refresh()) return true;
    waitForPost(wake_, kLateForce);
    return force_.refresh();
}

/// Counts answers that have come; more than there were messages is a fault of the service.
void HaplyDevice::settleAccount(int answers) {
    owed_ -= answers;
    if (owed_ >= 0) return;
    owed_ = 0;
    surplusAt_ = monotonicSeconds();
    complain(kSurplus);
}

bool HaplyDevice::isTrusted() const { return surplusAt_ < 0 || monotonicSeconds() - surplusAt_ > kDistrust; }

/// What has come since the last answer; false if the connection is broken.
bool HaplyDevice::takeUnasked() {
    int unasked = 0;
    const HaplyLink::Heard heard = link_->receiveWaiting(text_, unasked);
    settleAccount(unasked);
    return heard != HaplyLink::Heard::Broken;
}

/// Takes in the answer that has just come, or a newer one that has come since; false if the connection is broken.
bool HaplyDevice::takeAnswers() {
    int answers = 1;
    const HaplyLink::Heard heard = link_->receiveWaiting(text_, answers);
    settleAccount(answers);
    if (heard == HaplyLink::Heard::Broken) return false;
    if (owed_ == 0) hear();
    return true;
}

/// One message and its answer; false if the connection is broken.
bool HaplyDevice::exchange(const std::stop_token& stop) {
    if (!link_) return false;
    const bool isFresh = waitForForce();
    const bool isOpen = takeUnasked();
    const Vec3 force = isFresh && isTrusted() ? force_.value() : Vec3(Vec3::Zero());
    if (!isOpen || !link_->send(haplyForce(names_.device, force), kBroken)) {
        complain(kLost);
        return false;
    }
    ++owed_;
    switch (link_->receive(text_, kLateAnswer)) {
        case HaplyLink::Heard::Message:
            if (takeAnswers()) return true;
            break;
        case HaplyLink::Heard::Nothing:
            return waitForLateAnswer(stop);
        case HaplyLink::Heard::Broken:
            break;
    }
    complain(kLost);
    return false;
}

/// Counts one more answer that is late at this time, s. The force ends with each of them; a person hears of many.
bool HaplyDevice::isOftenLate(double now) {
    std::rotate(lateAnswers_.begin(), lateAnswers_.begin() + 1, lateAnswers_.end());
    lateAnswers_.back() = now;
    return now - lateAnswers_.front() < 1;
}

/// The device must not go on with a force while its answer is late.
bool HaplyDevice::waitForLateAnswer(const std::stop_token& stop) {
    const double began = monotonicSeconds();
    if (isOftenLate(began)) complain(kSlow);
    bool sound = link_->send(haplyForce(names_.device, Vec3::Zero()), kBroken);
    ++owed_;
    while (sound && owed_ > 0 && monotonicSeconds() < began + kBroken && !stop.stop_requested()) {
        if (monotonicSeconds() > began + kToldAfter) complain(kSlow);
        switch (link_->receive(text_, kGlance)) {
            case HaplyLink::Heard::Message:
                sound = takeAnswers();
                break;
            case HaplyLink::Heard::Nothing:
                break;
            case HaplyLink::Heard::Broken:
                sound = false;
        }
    }
    if (sound && owed_ == 0) return true;
    complain(sound ? kMute : kLost);
    return false;
}

/// Takes in an answer.
void HaplyDevice::hear() {
    Expected<HaplyReading> reading = readHaply(text_, names_);
    if (!reading) {  // the servo shall not go on with the place before until that is old
        HaplyReading none;
        none.usable = false;
        none.time = monotonicSeconds();
        reading_.write(none);
        return complain(kept(reading.error().message));
    }
    reading->time = monotonicSeconds();
    if (reading->hasTurn) turn_ = reading->hand.rotation;
    reading->hand.rotation = turn_;  // a grip that sleeps keeps its direction
    reading->usable &= isTrusted();
    reading_.write(*reading);
    if (reading->trouble != nullptr) return complain(reading->trouble);
    settle();
}

void HaplyDevice::complain(const char* sentence) {
    trouble_.store(sentence, std::memory_order_release);
    complainedAt_ = monotonicSeconds();
}

/// All is well: a sentence about what is over stays long enough to be read.
void HaplyDevice::settle() {
    if (complainedAt_ > 0 && monotonicSeconds() - complainedAt_ > kShownFor) {
        trouble_.store(nullptr, std::memory_order_relaxed);
        complainedAt_ = 0;
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

const char* HaplyDevice::trouble() const {
    if (const char* const text = trouble_.load(std::memory_order_acquire)) return text;  // with the letters behind it
    return HapticDevice::trouble();
}

}  // namespace tactooth
