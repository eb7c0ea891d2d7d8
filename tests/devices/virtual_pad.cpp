// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "virtual_pad.h"

#include <algorithm>
#include <stdexcept>

namespace tactooth::test {
namespace {

constexpr double kFullAxis = 32767, kFullMotor = 65535;

}  // namespace

VirtualPad::VirtualPad(std::string name, SDL_JoystickType type) : name_(std::move(name)) {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (SDL_InitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER) != 0) throw std::runtime_error(SDL_GetError());
    SDL_VirtualJoystickDesc desc;
    SDL_zero(desc);
    desc.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
    desc.type = static_cast<Uint16>(type);
    desc.naxes = 6;
    desc.nbuttons = 15;
    desc.name = name_.c_str();
    desc.userdata = this;
    desc.Rumble = &VirtualPad::rumble;
    SDL_LockJoysticks();
    const int index = SDL_JoystickAttachVirtualEx(&desc);
    if (index >= 0) {
        id_ = SDL_JoystickGetDeviceInstanceID(index);
        joystick_ = SDL_JoystickOpen(index);
    }
    SDL_UnlockJoysticks();
    if (joystick_ == nullptr) throw std::runtime_error(SDL_GetError());
}

VirtualPad::~VirtualPad() {
    SDL_LockJoysticks();
    for (int i = SDL_NumJoysticks() - 1; i >= 0; --i) {
        if (SDL_JoystickGetDeviceInstanceID(i) == id_) SDL_JoystickDetachVirtual(i);
    }
    SDL_JoystickClose(joystick_);
    SDL_UnlockJoysticks();
    SDL_QuitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER);
}

void VirtualPad::axis(int number, double value) {
    SDL_JoystickSetVirtualAxis(joystick_, number, static_cast<Sint16>(kFullAxis * value));
}

void VirtualPad::button(int number, bool down) {
    SDL_JoystickSetVirtualButton(joystick_, number, down ? SDL_PRESSED : SDL_RELEASED);
}

int VirtualPad::rumble(void* pad, Uint16 slow, Uint16 quick) {
    auto* const self = static_cast<VirtualPad*>(pad);
    self->slow_ = slow / kFullMotor;
    self->quick_ = quick / kFullMotor;
    self->strongestSlow_ = std::max(self->strongestSlow_.load(), self->slow_.load());
    self->strongestQuick_ = std::max(self->strongestQuick_.load(), self->quick_.load());
    return 0;
}

}  // namespace tactooth::test
