// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "devices/base/pad_mapping.h"
#include "geometry/util/expected.h"
#include "geometry/util/message.h"
#include "geometry/util/triple_buffer.h"

namespace tactooth {

/// The buttons of a pad that menus need, by their names on the usual one.
enum class PadButton { Up, Down, Left, Right, Start, Back, A, B, LeftShoulder, RightShoulder, LeftStick, RightStick };
inline constexpr std::size_t kPadButtons = 12;

/// What a person does with them.
struct PadButtons {
    std::array<bool, kPadButtons> down{};
    /// How often each has gone down since the pad is there: a short press is not lost on who looks seldom.
    std::array<std::uint32_t, kPadButtons> presses{};

    [[nodiscard]] bool isDown(PadButton button) const { return down[static_cast<std::size_t>(button)]; }
};

/// Any joystick at one moment: its axes and buttons as they come.
struct JoystickState {
    std::string name;
    bool isPad = false;  ///< with the usual sticks and triggers, so that it can steer
    bool rumbles = false;
    std::vector<double> axes;  ///< 0..1 from one end to the other
    std::vector<bool> buttons;
    PadButtons padButtons{};  ///< of a pad
};

/// How strongly a pad's two motors run, 0..1.
struct Rumble {
    double slow = 0;   ///< the heavy one: what presses
    double quick = 0;  ///< the light one: what shakes
};

/// A pad between the thread of the joysticks and the servo.
struct PadPort {
    TripleBuffer<PadState> state;  // joysticks -> servo
    TripleBuffer<Rumble> rumble;   // servo -> joysticks
};

/// All joysticks of this computer, read by a thread of its own 250 times a second (SDL's joystick subsystem alone, no
/// window). Ones that are plugged in or out are noticed.
class SdlJoysticks {
public:
    /// The one of this process; made when there is none. Fails with a sentence if the system lets nobody read
    /// joysticks.
    [[nodiscard]] static Expected<std::shared_ptr<SdlJoysticks>> shared();
    SdlJoysticks();
    ~SdlJoysticks();
    SdlJoysticks(const SdlJoysticks&) = delete;
    SdlJoysticks& operator=(const SdlJoysticks&) = delete;

    /// All that are plugged in. Any thread but the servo's.
    [[nodiscard]] std::vector<JoystickState> states() const;

    /// From now on `port` is fed by the first pad whose name holds `name` (empty: any), also by one that is plugged in
    /// later; nullptr: no more. The port outlives this. Fails if another port is being fed.
    [[nodiscard]] Expected<void> feed(PadPort* port, const std::string& name);

private:
    class Worker;
    void run(const std::stop_token& stop, Worker& worker);

    mutable std::mutex mutex_;  // of everything up to the thread
    std::vector<JoystickState> states_;
    PadPort* port_ = nullptr;
    std::string wanted_;
    Message failure_;
    bool started_ = false;  // or failed
    std::jthread thread_;   // last: it uses all of the above
};

}  // namespace tactooth
