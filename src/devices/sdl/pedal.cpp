// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/sdl/pedal.h"

#include <algorithm>
#include <cmath>

#include "devices/base/messages.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

constexpr double kDeadZone = 0.05;          // of the travel at both ends: a foot resting on the pedal does not press it
constexpr double kCalibrationTravel = 0.4;  // of an axis's full travel; a longer motion counts as pressing a pedal
constexpr double kBack = 0.15;              // of the pressed travel: this close to the start, the pedal is up again
constexpr double kMinTravel = 0.02;         // of an axis: a shorter travel is not a pedal but noise

std::optional<double> stateOf(const PedalBinding& choice, const JoystickState& joystick) {
    const auto number = static_cast<std::size_t>(choice.number);
    if (choice.kind == PedalBinding::Kind::Axis && number < joystick.axes.size()) return joystick.axes[number];
    if (choice.kind == PedalBinding::Kind::Button && number < joystick.buttons.size()) {
        return joystick.buttons[number] ? 1.0 : 0.0;
    }
    return std::nullopt;
}

/// Removes the part before the next colon from `text` and returns it.
std::string cutWord(std::string& text) {
    const std::size_t end = std::min(text.find(':'), text.size());
    const std::string word = text.substr(0, end);
    text.erase(0, std::min(end + 1, text.size()));
    return word;
}

}  // namespace

Expected<PedalBinding> parsePedal(const std::string& text) {
    PedalBinding choice;
    if (text.empty()) return choice;
    std::string rest = text;
    const std::string kind = cutWord(rest);
    const auto number = toNumber<int>(cutWord(rest));
    constexpr int kMax = 31;
    if ((kind != "axis" && kind != "button") || !number || *number < 0 || *number > kMax) {
        return unexpected(msg::kUnknownPedal, text);
    }
    choice.kind = kind == "axis" ? PedalBinding::Kind::Axis : PedalBinding::Kind::Button;
    choice.number = *number;
    choice.joystick = rest;
    return choice;
}

std::string pedalText(const PedalBinding& choice) {
    if (choice.kind == PedalBinding::Kind::None) return {};
    const char* const kind = choice.kind == PedalBinding::Kind::Axis ? "axis:" : "button:";
    return kind + std::to_string(choice.number) + (choice.joystick.empty() ? "" : ":" + choice.joystick);
}

std::optional<double> pedalOf(const PedalBinding& choice, std::span<const JoystickState> joysticks) {
    for (const JoystickState& joystick : joysticks) {
        if (joystick.name.find(choice.joystick) == std::string::npos) continue;
        const auto state = stateOf(choice, joystick);
        if (!state || choice.kind == PedalBinding::Kind::Button) {
            if (state) return state;
            continue;
        }
        const double travel = choice.down - choice.up;
        if (std::abs(travel) < kMinTravel) return 0;
        return std::clamp(((*state - choice.up) / travel - kDeadZone) / (1 - 2 * kDeadZone), 0.0, 1.0);
    }
    return std::nullopt;
}

std::optional<PedalBinding> PedalCalibrator::update(std::span<const JoystickState> joysticks) {
    const auto isOther = [](const JoystickState& a, const JoystickState& b) {
        return a.name != b.name || a.axes.size() != b.axes.size() || a.buttons.size() != b.buttons.size();
    };
    // If a joystick was plugged in or out, the calibration starts again.
    if (!std::ranges::equal(joysticks, first_, [&](const auto& a, const auto& b) { return !isOther(a, b); })) {
        first_.assign(joysticks.begin(), joysticks.end());
        extremes_ = first_;
    }
    for (std::size_t j = 0; j < joysticks.size(); ++j) {
        const JoystickState& now = joysticks[j];
        for (std::size_t i = 0; i < now.buttons.size(); ++i) {
            if (extremes_[j].buttons[i] != first_[j].buttons[i] && now.buttons[i] == first_[j].buttons[i]) {
                return PedalBinding{PedalBinding::Kind::Button, static_cast<int>(i), now.name};
            }
            if (now.buttons[i] != first_[j].buttons[i]) extremes_[j].buttons[i] = now.buttons[i];
        }
        for (std::size_t i = 0; i < now.axes.size(); ++i) {
            const double start = first_[j].axes[i];
            double& end = extremes_[j].axes[i];
            if (std::abs(now.axes[i] - start) > std::abs(end - start)) end = now.axes[i];
            const double travel = std::abs(end - start);
            if (travel > kCalibrationTravel && std::abs(now.axes[i] - start) < kBack * travel) {
                return PedalBinding{PedalBinding::Kind::Axis, static_cast<int>(i), now.name, start, end};
            }
        }
    }
    return std::nullopt;
}

}  // namespace tactooth
