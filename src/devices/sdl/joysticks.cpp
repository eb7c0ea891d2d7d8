// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/sdl/joysticks.h"

#include "devices/base/messages.h"

#include <SDL.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <utility>

namespace tactooth {
namespace {

constexpr auto kPeriod = std::chrono::milliseconds(4);  // 250 Hz: the highest rate of USB pads, or close to it
constexpr unsigned kRumbleEvery = 5;                    // periods between two motor commands: wireless pads drop more
constexpr Uint32 kRumbleMs = 100;     // ms for which a command lasts: if the servo thread hangs, the motors stop
constexpr double kFullAxis = 32767;   // full scale in SDL
constexpr double kFullMotor = 65535;  // full scale in SDL
constexpr std::size_t kMaxAxes = 32;  // a driver that reports more is broken

double fromAxis(Sint16 value) { return std::max(-1.0, static_cast<double>(value) / kFullAxis); }

JoystickState stateOf(SDL_Joystick* joystick, bool isPad) {
    JoystickState state;
    const char* const name = SDL_JoystickName(joystick);
    state.name = name != nullptr ? name : "joystick";
    state.isPad = isPad;
    state.rumbles = SDL_JoystickHasRumble(joystick) == SDL_TRUE;
    const auto count = [](int number) { return std::min(static_cast<std::size_t>(std::max(0, number)), kMaxAxes); };
    state.axes.resize(count(SDL_JoystickNumAxes(joystick)));
    for (std::size_t i = 0; i < state.axes.size(); ++i) {
        state.axes[i] = (1 + fromAxis(SDL_JoystickGetAxis(joystick, static_cast<int>(i)))) / 2;
    }
    state.buttons.resize(count(SDL_JoystickNumButtons(joystick)));
    for (std::size_t i = 0; i < state.buttons.size(); ++i) {
        state.buttons[i] = SDL_JoystickGetButton(joystick, static_cast<int>(i)) != 0;
    }
    return state;
}

/// Reads which buttons are down and counts those that were not down before.
void follow(PadButtons& buttons, SDL_GameController* pad) {
    constexpr std::array<SDL_GameControllerButton, kPadButtons> kOrder = {SDL_CONTROLLER_BUTTON_DPAD_UP,
                                                                          SDL_CONTROLLER_BUTTON_DPAD_DOWN,
                                                                          SDL_CONTROLLER_BUTTON_DPAD_LEFT,
                                                                          SDL_CONTROLLER_BUTTON_DPAD_RIGHT,
                                                                          SDL_CONTROLLER_BUTTON_START,
                                                                          SDL_CONTROLLER_BUTTON_BACK,
                                                                          SDL_CONTROLLER_BUTTON_A,
                                                                          SDL_CONTROLLER_BUTTON_B,
                                                                          SDL_CONTROLLER_BUTTON_LEFTSHOULDER,
                                                                          SDL_CONTROLLER_BUTTON_RIGHTSHOULDER,
                                                                          SDL_CONTROLLER_BUTTON_LEFTSTICK,
                                                                          SDL_CONTROLLER_BUTTON_RIGHTSTICK,
                                                                          SDL_CONTROLLER_BUTTON_X,
                                                                          SDL_CONTROLLER_BUTTON_Y};
    for (std::size_t i = 0; i < kPadButtons; ++i) {
        const bool wasDown = std::exchange(buttons.down[i], SDL_GameControllerGetButton(pad, kOrder[i]) != 0);
        if (buttons.down[i] && !wasDown) ++buttons.presses[i];
    }
}

PadState padStateOf(SDL_GameController* pad) {
    const auto axis = [pad](SDL_GameControllerAxis which) { return fromAxis(SDL_GameControllerGetAxis(pad, which)); };
    const auto button = [pad](SDL_GameControllerButton which) { return SDL_GameControllerGetButton(pad, which) != 0; };
    constexpr SDL_GameControllerButton kBits[] = {SDL_CONTROLLER_BUTTON_B, SDL_CONTROLLER_BUTTON_A,
                                                  SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, SDL_CONTROLLER_BUTTON_X,
                                                  SDL_CONTROLLER_BUTTON_Y};
    PadState state;
    state.connected = true;
    state.leftStick = {axis(SDL_CONTROLLER_AXIS_LEFTX), axis(SDL_CONTROLLER_AXIS_LEFTY)};
    state.rightStick = {axis(SDL_CONTROLLER_AXIS_RIGHTX), axis(SDL_CONTROLLER_AXIS_RIGHTY)};
    state.leftTrigger = axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT);
    state.rightTrigger = axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT);
    state.lift = button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER);
    for (unsigned bit = 0; bit < std::size(kBits); ++bit) state.buttons |= button(kBits[bit]) ? 1U << bit : 0U;
    return state;
}

}  // namespace

/// The joysticks that are plugged in; used only by the thread that owns SDL.
class SdlJoysticks::Worker {
public:
    Worker() {
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");                // the program handles Ctrl+C itself
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");  // SDL has no window that could have the focus
        works_ = SDL_InitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER) == 0;
    }
    ~Worker() {
        closeAll();
        if (works_) SDL_QuitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER);
        SDL_TLSCleanup();  // SDL did not create this thread, so it does not notice its end
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    [[nodiscard]] bool works() const { return works_; }

    [[nodiscard]] std::vector<JoystickState> readAll() {
        SDL_JoystickUpdate();
        SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);  // no code reads them
        openNew();
        std::vector<JoystickState> states;
        for (Open& each : open_) {
            states.push_back(stateOf(each.joystick, each.pad != nullptr));
            if (each.pad == nullptr) continue;
            follow(each.buttons, each.pad);
            states.back().padButtons = each.buttons;
        }
        return states;
    }

    void feed(PadPort& port, const std::string& wanted) {
        SDL_GameController* const pad = find(wanted);
        port.state.write(pad != nullptr ? padStateOf(pad) : PadState{});
        if (pad != fed_) silence();
        fed_ = pad;
        if (fed_ == nullptr || ++sinceRumble_ < kRumbleEvery || !port.rumble.refresh()) return;
        sinceRumble_ = 0;
        const auto motor = [](double part) { return static_cast<Uint16>(kFullMotor * std::clamp(part, 0.0, 1.0)); };
        const Rumble& rumble = port.rumble.value();
        SDL_GameControllerRumble(fed_, motor(rumble.slow), motor(rumble.quick), kRumbleMs);
    }
    void silence() {
        if (fed_ != nullptr) SDL_GameControllerRumble(fed_, 0, 0, 0);
        fed_ = nullptr;
    }

private:
    struct Open {
        SDL_JoystickID id;
        SDL_Joystick* joystick;
        SDL_GameController* pad;  // nullptr: it does not have the usual sticks
        PadButtons buttons;
    };

    void openNew() {
        std::erase_if(open_, [this](const Open& each) {
            if (SDL_JoystickGetAttached(each.joystick) == SDL_TRUE) return false;
            close(each);
            return true;
        });
        SDL_LockJoysticks();  // none may disappear while they are counted
        for (int i = 0; i < SDL_NumJoysticks(); ++i) {
            const SDL_JoystickID id = SDL_JoystickGetDeviceInstanceID(i);
            if (id < 0 || std::ranges::find(open_, id, &Open::id) != open_.end()) continue;
            SDL_GameController* const pad = SDL_IsGameController(i) == SDL_TRUE ? SDL_GameControllerOpen(i) : nullptr;
            SDL_Joystick* const joystick = SDL_JoystickOpen(i);
            if (joystick != nullptr) open_.push_back({id, joystick, pad, {}});
        }
        SDL_UnlockJoysticks();
    }
    [[nodiscard]] SDL_GameController* find(const std::string& wanted) const {
        const auto found = std::ranges::find_if(open_, [&](const Open& each) {
            const char* const name = SDL_JoystickName(each.joystick);
            return each.pad != nullptr && std::string(name != nullptr ? name : "").find(wanted) != std::string::npos;
        });
        return found == open_.end() ? nullptr : found->pad;
    }
    void close(const Open& each) {
        if (each.pad == fed_) fed_ = nullptr;
        if (each.pad != nullptr) SDL_GameControllerClose(each.pad);
        SDL_JoystickClose(each.joystick);
    }
    void closeAll() {
        silence();
        for (const Open& each : open_) close(each);
        open_.clear();
    }

    bool works_ = false;
    std::vector<Open> open_;
    SDL_GameController* fed_ = nullptr;
    unsigned sinceRumble_ = 0;
};

Expected<std::shared_ptr<SdlJoysticks>> SdlJoysticks::shared() {
    static std::mutex mutex;
    static std::weak_ptr<SdlJoysticks> running;
    const std::lock_guard lock(mutex);
    auto joysticks = running.lock();
    if (joysticks == nullptr) joysticks = std::make_shared<SdlJoysticks>();
    running = joysticks;
    if (!joysticks->failure_.empty()) return unexpected(joysticks->failure_);
    return joysticks;
}

SdlJoysticks::SdlJoysticks() {
    std::condition_variable_any started;
    std::unique_lock lock(mutex_);
    thread_ = std::jthread([this, &started](const std::stop_token& stop) {
        Worker worker;
        {
            const std::lock_guard guard(mutex_);
            if (!worker.works()) failure_ = {msg::kJoysticksNotRead, SDL_GetError()};
            if (worker.works()) states_ = worker.readAll();
            started_ = true;
            started.notify_all();
        }
        run(stop, worker);
    });
    started.wait(lock, [this] { return started_; });
}

SdlJoysticks::~SdlJoysticks() = default;

void SdlJoysticks::run(const std::stop_token& stop, Worker& worker) {
    std::condition_variable_any wake;
    std::mutex none;
    std::unique_lock sleeping(none);
    while (worker.works() && !wake.wait_for(sleeping, stop, kPeriod, [] { return false; }) && !stop.stop_requested()) {
        std::vector<JoystickState> states = worker.readAll();
        const std::lock_guard lock(mutex_);
        states_ = std::move(states);
        port_ != nullptr ? worker.feed(*port_, wanted_) : worker.silence();
    }
}

std::vector<JoystickState> SdlJoysticks::states() const {
    const std::lock_guard lock(mutex_);
    return states_;
}

Expected<void> SdlJoysticks::feed(PadPort* port, const std::string& name) {
    const std::lock_guard lock(mutex_);
    if (port != nullptr && port_ != nullptr) return unexpected(msg::kGamepadInUse);
    port_ = port;
    wanted_ = name;
    return {};
}

}  // namespace tactooth
