// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SDL.h>

#include <atomic>
#include <string>

namespace tactooth::test {

/// A virtual joystick in SDL: the test sets its inputs, which the program reads, and reads the motor commands of the
/// program.
class VirtualPad {
public:
    explicit VirtualPad(std::string name, SDL_JoystickType type = SDL_JOYSTICK_TYPE_GAMECONTROLLER);
    ~VirtualPad();
    VirtualPad(const VirtualPad&) = delete;
    VirtualPad& operator=(const VirtualPad&) = delete;

    void axis(int number, double value);  ///< -1..1
    void button(int number, bool down);
    [[nodiscard]] double slowMotor() const { return slow_.load(); }    ///< 0..1, the last command
    [[nodiscard]] double quickMotor() const { return quick_.load(); }  ///< 0..1
    void forgetMotors() { strongestSlow_ = strongestQuick_ = 0; }
    [[nodiscard]] double strongestSlow() const { return strongestSlow_.load(); }
    [[nodiscard]] double strongestQuick() const { return strongestQuick_.load(); }

private:
    static int rumble(void* pad, Uint16 slow, Uint16 quick);

    std::string name_;
    SDL_JoystickID id_ = -1;
    SDL_Joystick* joystick_ = nullptr;
    std::atomic<double> slow_{0}, quick_{0}, strongestSlow_{0}, strongestQuick_{0};
};

}  // namespace tactooth::test
