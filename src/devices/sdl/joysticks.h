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

/// The buttons of a pad for use in menus, by their names on the usual pad.
enum class PadButton {
    Up,
    Down,
    Left,
    Right,
    Start,
    Back,
    A,
    B,
    LeftShoulder,
    RightShoulder,
    LeftStick,
    RightStick,
    X,
    Y
};
inline constexpr std::size_t kPadButtons = 14;

/// State of these buttons.
struct PadButtons {
    std::array<bool, kPadButtons> down{};
    /// How often each button has been pressed since the pad was plugged in. A caller that polls rarely does not miss a
    /// short press.
    std::array<std::uint32_t, kPadButtons> presses{};

    [[nodiscard]] bool isDown(PadButton button) const { return down[static_cast<std::size_t>(button)]; }
};

/// Any joystick at one moment: its raw axes and buttons.
struct JoystickState {
    std::string name;
    bool isPad = false;  ///< has the usual sticks and triggers, so that it can steer
    bool rumbles = false;
    std::vector<double> axes;  ///< 0..1 from one end to the other
    std::vector<bool> buttons;
    PadButtons padButtons{};  ///< valid for a pad
};

/// Strength of a pad's two motors, 0..1.
struct Rumble {
    double slow = 0;   ///< the heavy motor: the steady force
    double quick = 0;  ///< the light motor: vibration
};

/// Data of a pad shared by the joystick thread and the servo thread.
struct PadPort {
    TripleBuffer<PadState> state;  // joysticks -> servo
    TripleBuffer<Rumble> rumble;   // servo -> joysticks
};

/// All joysticks of this computer, read by a separate thread 250 times a second. Uses only SDL's joystick subsystem, no
/// window. Detects joysticks that are plugged in or out.
class SdlJoysticks {
public:
    /// The instance of this process; created on demand. Fails with a sentence if the system does not permit the user to
    /// read joysticks.
    [[nodiscard]] static Expected<std::shared_ptr<SdlJoysticks>> shared();
    SdlJoysticks();
    ~SdlJoysticks();
    SdlJoysticks(const SdlJoysticks&) = delete;
    SdlJoysticks& operator=(const SdlJoysticks&) = delete;

    /// All joysticks that are plugged in. Any thread except the servo thread.
    [[nodiscard]] std::vector<JoystickState> states() const;

    /// Connects `port` to the first pad whose name contains `name` (empty: any), also to one that is plugged in later;
    /// nullptr disconnects. The port must outlive this object. Fails if another port is connected.
    [[nodiscard]] Expected<void> feed(PadPort* port, const std::string& name);

private:
    class Worker;
    void run(const std::stop_token& stop, Worker& worker);

    mutable std::mutex mutex_;  // protects all members up to the thread
    std::vector<JoystickState> states_;
    PadPort* port_ = nullptr;
    std::string wanted_;
    Message failure_;
    bool started_ = false;  // true also if the start failed
    std::jthread thread_;   // last member: it uses all of the above
};

}  // namespace tactooth
