// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/spacemouse/space_mouse_device.h"

#include "devices/base/messages.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>

#include <spnav.h>  // last: it defines X11's macros

namespace tactooth {
namespace {

constexpr double kFullAxis = 350;     // counts of a cap at full deflection
constexpr double kDeadZone = 0.05;    // fraction of full deflection: a cap returns to within this value
constexpr double kFastest = 25;       // mm/s, as with a gamepad
constexpr double kFastestTurn = 1.2;  // rad/s
constexpr double kStiffness = 2;      // N/mm: the rate controller yields, so a stiffer wall gives no stronger force
constexpr int kEventTimeoutMs = 100;  // ms to wait for the next event: closing takes no longer
constexpr int kMaxEvents = 1000;  // at once: an endless stream of a driver must not keep the newest state from the pose
constexpr auto kRetry = std::chrono::seconds(1);
const Message kLost(msg::kSpaceMouseLost);

std::atomic<bool> libraryInUse{false};

double part(int count) {
    const double deflection = std::clamp(count / kFullAxis, -1.0, 1.0);
    return std::copysign(std::max(0.0, std::abs(deflection) - kDeadZone) / (1 - kDeadZone), deflection);
}

void take(const spnav_event& event, SpaceMouseState& state) {
    if (event.type == SPNAV_EVENT_MOTION) {
        const spnav_event_motion& motion = event.motion;
        state.axes = {motion.x, motion.y, motion.z, motion.rx, motion.ry, motion.rz};
    } else if (event.type == SPNAV_EVENT_BUTTON && event.button.bnum >= 0 && event.button.bnum < 32) {
        const std::uint32_t bit = 1U << event.button.bnum;
        state.buttons = event.button.press != 0 ? state.buttons | bit : state.buttons & ~bit;
    }
}

/// Waits for the driver's next event; false if the connection is broken.
bool waitForEvent() {
    pollfd waiting{spnav_fd(), POLLIN, 0};
    return poll(&waiting, 1, kEventTimeoutMs) >= 0 && (waiting.revents & (POLLHUP | POLLERR | POLLNVAL)) == 0;
}

}  // namespace

RateCommand rateCommand(const SpaceMouseState& state) {
    const auto& [x, y, z, rx, ry, rz] = state.axes;
    // The driver's axes are right, up and away; its rotations are right-handed about these (libspnav,
    // spnav_posrot_moveobj).
    return {kFastest * Vec3(part(x), part(z), part(y)), kFastestTurn * Vec3(part(rx), part(rz), part(ry))};
}

SpaceMouseDevice::SpaceMouseDevice() {
    info_.name = "SpaceMouse";
    info_.poseLimits = PoseLimits::unlimited();
    info_.sensesRotation = true;
    info_.buttonCount = 2;
    info_.stiffness = kStiffness;
    info_.workspace = Vec3::Constant(2 * RateController::kReach);
}

SpaceMouseDevice::~SpaceMouseDevice() { close(); }

Expected<void> SpaceMouseDevice::open() {
    close();
    if (libraryInUse.exchange(true)) return unexpected(msg::kSpaceMouseInUse);
    if (spnav_open() != 0) {
        libraryInUse.store(false);
        return unexpected(msg::kSpaceMouseNoDriver);
    }
    open_ = true;
    hand_ = RateController();
    SpaceMouseState atRest;
    atRest.connected = true;
    state_.write(atRest);
    listener_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
    return {};
}

void SpaceMouseDevice::close() {
    if (!std::exchange(open_, false)) return;
    listener_ = {};
    spnav_close();
    libraryInUse.store(false);
}

void SpaceMouseDevice::run(const std::stop_token& stop) {
    std::condition_variable_any wake;
    std::mutex none;
    std::unique_lock sleeping(none);
    SpaceMouseState state;
    state.connected = true;
    while (!stop.stop_requested()) {
        const bool there = state.connected ? waitForEvent() : spnav_open() == 0;
        if (there) {
            state.connected = true;
            spnav_event event{};
            for (int i = 0; i < kMaxEvents && spnav_poll_event(&event) != 0; ++i) take(event, state);
        } else if (std::exchange(state, {}).connected) {
            spnav_close();
        }
        state_.write(state);
        if (!there) wake.wait_for(sleeping, stop, kRetry, [] { return false; });
    }
}

DeviceSample SpaceMouseDevice::read(double elapsed) {
    state_.refresh();
    const SpaceMouseState& state = state_.value();
    lost_.store(!state.connected, std::memory_order_relaxed);
    DeviceSample sample;
    sample.connected = state.connected;
    sample.hand = hand_.advance(rateCommand(state), elapsed);
    sample.buttons = state.buttons;
    return sample;
}

const Message* SpaceMouseDevice::faultMessage() const {
    return lost_.load(std::memory_order_relaxed) ? &kLost : HapticDevice::faultMessage();
}

}  // namespace tactooth
