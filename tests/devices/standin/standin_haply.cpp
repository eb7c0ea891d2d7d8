// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "standin_haply.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "web_socket_server.h"

namespace tactooth::test {
namespace {

constexpr double kMessageTime = 0.001;                         // s of simulated time for each message
constexpr double kMass = 2e-4, kSpring = 0.5, kDamper = 0.02;  // N*s^2/mm, N/mm, N*s/mm: a hand with the arm
constexpr auto kSlowness = std::chrono::milliseconds(20);
constexpr auto kFloodPause = std::chrono::microseconds(50);

std::string numbers(const char* pattern, double a, double b, double c, double d = 0) {
    char text[200];
    std::snprintf(text, sizeof text, pattern, a, b, c, d);
    return text;
}

/// Raises the thread's priority: an answer that waits for other work of the machine would itself be a fault under test.
void takePriority() {
    sched_param priority{};
    priority.sched_priority = 70;  // if the system permits it
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
}

bool hasInput(int socket, int milliseconds = 5) {
    pollfd waiting{socket, POLLIN, 0};
    return poll(&waiting, 1, milliseconds) > 0;
}

}  // namespace

StandinHaply::StandinHaply() {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof address;
    if (bind(listener_, reinterpret_cast<sockaddr*>(&address), length) != 0) std::perror("bind");
    listen(listener_, 4);
    getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &length);
    port_ = ntohs(address.sin_port);
    acceptor_ = std::jthread([this](const std::stop_token& stop) { accept(stop); });
}

StandinHaply::~StandinHaply() {
    acceptor_ = {};
    servers_.clear();
    ::close(listener_);
}

void StandinHaply::accept(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        if (!hasInput(listener_)) continue;
        const int socket = ::accept(listener_, nullptr, nullptr);
        if (socket < 0) continue;
        const int yes = 1;
        setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
        servers_.emplace_back([this, socket](const std::stop_token& end) {
            serve(socket, end);
            ::close(socket);
        });
    }
}

void StandinHaply::serve(int socket, const std::stop_token& stop) {
    takePriority();
    WebSocketServer web(socket);
    bool foreign = false;
    {
        const std::lock_guard lock(mutex_);
        foreign = foreign_;
    }
    if (!(foreign ? web.refuseHandshake() : web.handshakeWith())) return;
    {
        const std::lock_guard lock(mutex_);
        ++connections_;
    }
    bool open = web.send(state(true));
    std::string message;
    while (open && !stop.stop_requested() && fault() != HaplyFault::Drop) {
        if (fault() == HaplyFault::Flood) {
            std::this_thread::sleep_for(kFloodPause);
            open = web.send(state(false));
        }
        if (!hasInput(socket, fault() == HaplyFault::Flood ? 0 : 5)) continue;
        if (!web.receive(message)) break;
        take(message);
        if (fault() == HaplyFault::Drop) break;
        if (isLate()) std::this_thread::sleep_for(kSlowness);
        for (int i = answersToAMessage(); i > 0 && open; --i) open = web.send(state(false));
    }
    const std::lock_guard lock(mutex_);
    --connections_;
    const bool hadForce = hands_[0].force != std::array<double, 3>{};
    for (Hand& hand : hands_) hand.force = {};  // a device without commands renders no force
    noteZero(hadForce);
}

/// `hadForce`: before the force of the present moment.
void StandinHaply::noteZero(bool hadForce) {
    if (hands_[0].force != std::array<double, 3>{}) {
        zeroAt_ = 0;
    } else if (hadForce) {
        zeroAt_ = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    }
}

bool StandinHaply::isLate() const {
    const std::lock_guard lock(mutex_);
    return fault_ == HaplyFault::Slow || (fault_ == HaplyFault::Hiccup && sinceFault_ == 1);
}

/// Takes the force from a message and moves the hand of that device by one step.
void StandinHaply::take(const std::string& message) {
    const auto json = nlohmann::json::parse(message);
    const std::lock_guard lock(mutex_);
    for (const auto& device : json.at("inverse3")) {
        Hand& hand = hands_[device.at("device_id") == kFirst ? 0 : 1];
        const auto& values = device.at("commands").at("set_cursor_force").at("values");
        const bool hadForce = hand.force != std::array<double, 3>{};
        hand.force = {values.at("x"), values.at("y"), values.at("z")};
        if (&hand == hands_.data()) noteZero(hadForce);
        for (std::size_t i = 0; i < 3; ++i) {
            const double push = hand.force[i] + kSpring * (wanted_[i] - hand.position[i]) - kDamper * hand.speed[i];
            hand.speed[i] += kMessageTime / kMass * push;
            hand.position[i] += kMessageTime * hand.speed[i];
        }
        if (&hand != &hands_[0]) continue;
        ++messages_;
        ++sinceFault_;
        if (hand.force != std::array<double, 3>{}) lastForce_ = sinceFault_;
        lastForceReceived_ = std::hypot(hand.force[0], hand.force[1], hand.force[2]);
    }
}

int StandinHaply::answersToAMessage() const {
    switch (fault()) {
        case HaplyFault::Mute:
            return 0;
        case HaplyFault::Double:
            return 2;
        case HaplyFault::Twenty:
            return 20;
        default:
            return 1;
    }
}

/// Offset of the reported position to the right of the true one, mm.
double StandinHaply::aside() const {
    // The jump alternates with every message: if the machine stalls at that moment, a single jump could be a quick
    // motion of the hand.
    const bool isOdd = sinceFault_ % 2 == 1;
    switch (fault_) {
        case HaplyFault::Units:  // otherwise a position in the middle would still look plausible
            return 3;
        case HaplyFault::Jump:
            return isOdd ? 50 : 0;
        case HaplyFault::Jitter:
            return isOdd ? 4.9 : 0;
        case HaplyFault::Drift:
            return std::min(900.0, 3.0 * static_cast<double>(sinceFault_));
        default:
            return 0;
    }
}

std::string StandinHaply::turnOfGrip() const {
    std::array<double, 4> turn = grip_;
    const bool isOdd = sinceFault_ % 2 == 1;
    if (fault_ == HaplyFault::InvalidRotation) turn = {0.3, 0.1, 0, 0.2};
    if (fault_ == HaplyFault::FlippingTurn && isOdd) turn = {0.70710678, 0.70710678, 0, 0};
    if (fault_ == HaplyFault::NegatedTurn && isOdd) {
        for (double& number : turn) number = -number;
    }
    return numbers(R"({"w":%.7f,"x":%.7f,"y":%.7f,"z":%.7f})", turn[0], turn[1], turn[2], turn[3]);
}

std::string StandinHaply::placeOf(const Hand& hand) const {
    const double scale = fault_ == HaplyFault::Units ? 1 : 1e-3;
    if (fault_ == HaplyFault::NotANumber) return R"({"x":null,"y":0.0,"z":0.0})";
    return numbers(R"({"x":%.9f,"y":%.9f,"z":%.9f})", scale * (hand.position[0] + aside()), scale * hand.position[1],
                   scale * hand.position[2]);
}

std::string StandinHaply::state(bool isFirst) {
    const std::lock_guard lock(mutex_);
    if (isFirst && !firstMessage_.empty()) return firstMessage_;
    if (fault_ == HaplyFault::Malformed) return R"({"inverse3":[{"device_id":"049D","state":{"cursor_)";
    if (fault_ == HaplyFault::Version) return R"({"devices":[{"type":"inverse3","id":7,"pos":[0.1,0.2,0.3]}]})";
    std::string arms;
    for (const Hand& hand : hands_) {
        if (fault_ == HaplyFault::Gone && &hand == hands_.data()) continue;
        const auto isFine = [this](HaplyFault fault) { return fault_ != fault ? "true" : "false"; };
        arms += std::string(arms.empty() ? "" : ",") + R"({"device_id":")" + hand.id + R"(",)" +
                (isFirst ? R"("config":{"handedness":"right"},)" : "") + R"("state":{"cursor_position":)" +
                placeOf(hand) + R"(,"control_mode":"cursor_force"},"status":{"calibrated":)" +
                isFine(HaplyFault::NotCalibrated) + R"(,"ready":)" + isFine(HaplyFault::NotReady) +
                R"(,"power_supply":)" + isFine(HaplyFault::NoPower) + "}}";
    }
    const auto button = [&](unsigned i) { return (buttons_ >> i & 1U) != 0 ? "true" : "false"; };
    const std::string grip = R"({"device_id":"61576","state":{"orientation":)" + turnOfGrip() + R"(,"buttons":{"a":)" +
                             button(0) + R"(,"b":)" + button(1) + R"(,"c":)" + button(2) +
                             R"(}},"status":{"awake":true}})";
    return std::string(isFirst ? R"({"session_id":1,)" : "{") + R"("inverse3":[)" + arms +
           R"(],"verse_grip":[],"wireless_verse_grip":[)" + (gripThere_ ? grip : "") + "]}";
}

HaplyFault StandinHaply::fault() const {
    const std::lock_guard lock(mutex_);
    return fault_;
}

void StandinHaply::setFault(HaplyFault fault) {
    const std::lock_guard lock(mutex_);
    fault_ = fault;
    sinceFault_ = lastForce_ = 0;
}

void StandinHaply::wantPosition(double x, double y, double z) {
    const std::lock_guard lock(mutex_);
    wanted_ = {1000 * x, 1000 * y, 1000 * z};
}

void StandinHaply::setGrip(std::array<double, 4> orientation, unsigned buttons) {
    const std::lock_guard lock(mutex_);
    grip_ = orientation;
    buttons_ = buttons;
}

void StandinHaply::setGripThere(bool there) {
    const std::lock_guard lock(mutex_);
    gripThere_ = there;
}

void StandinHaply::setFirstMessage(std::string text) {
    const std::lock_guard lock(mutex_);
    firstMessage_ = std::move(text);
}

void StandinHaply::setForeign(bool foreign) {
    const std::lock_guard lock(mutex_);
    foreign_ = foreign;
}

double StandinHaply::force() const {
    const std::lock_guard lock(mutex_);
    return std::hypot(hands_[0].force[0], hands_[0].force[1], hands_[0].force[2]);
}

double StandinHaply::zeroAt() const {
    const std::lock_guard lock(mutex_);
    return zeroAt_;
}

double StandinHaply::lastForceReceived() const {
    const std::lock_guard lock(mutex_);
    return lastForceReceived_;
}

long StandinHaply::messagesSinceFault() const {
    const std::lock_guard lock(mutex_);
    return sinceFault_;
}

long StandinHaply::lastForceSinceFault() const {
    const std::lock_guard lock(mutex_);
    return lastForce_;
}

long StandinHaply::messages() const {
    const std::lock_guard lock(mutex_);
    return messages_;
}

int StandinHaply::connections() const {
    const std::lock_guard lock(mutex_);
    return connections_;
}

}  // namespace tactooth::test
