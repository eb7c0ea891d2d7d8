// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/hand_link.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>

namespace tactooth {
namespace {

std::array<double, 3> numbersOf(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }
Vec3 vectorFrom(const std::array<double, 3>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

/// Copies as many whole letters of a UTF-8 text as fit, and a zero.
template <std::size_t kSize>
void put(std::string_view text, std::array<char, kSize>& place) {
    std::size_t length = std::min(text.size(), kSize - 1);
    const auto continuesLetter = [&](std::size_t at) {
        return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
    };
    while (length > 0 && continuesLetter(length)) --length;
    place.fill(0);
    std::copy_n(text.begin(), length, place.begin());
}

template <std::size_t kSize>
std::string textIn(const std::array<char, kSize>& place) {
    return {place.begin(), std::ranges::find(place, '\0')};
}

bool areFiniteAndNotNegative(std::initializer_list<double> values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value) && value >= 0; });
}

/// Whether a safety limiter takes these limits.
bool isValid(const ForceLimits& limits) {
    return areFiniteAndNotNegative({limits.force, limits.torque, limits.slew, limits.rampTime, limits.tickTimeout,
                                    limits.torqueSlew, limits.friction}) &&
           limits.slew > 0 && limits.torqueSlew > 0 && limits.tickTimeout > 0 && limits.continuousForce > 0 &&
           limits.power >= 0;
}

/// Whether a pose validator takes these limits.
bool isValid(const PoseLimits& limits) {
    return areFiniteAndNotNegative({limits.freeJump, limits.freeSpeed, limits.jump, limits.speed,
                                    limits.maxAngularSpeed, limits.rotationPeriod, limits.maxAge}) &&
           limits.freeSpeed > 0 && limits.jump > 0 && limits.speed > 0 && limits.maxAngularSpeed > 0;
}

}  // namespace

DeviceDescription descriptionOf(const HapticDevice& device) {
    const DeviceInfo& info = device.info();
    DeviceDescription description;
    put(info.name, description.name);
    description.limits = info.limits;
    description.poseLimits = info.poseLimits;
    description.workspace = numbersOf(info.workspace);
    description.hasWorkspaceCentre = info.workspaceCentre.has_value();
    description.workspaceCentre = numbersOf(info.workspaceCentre.value_or(Vec3::Zero()));
    description.stiffness = info.stiffness;
    description.buttonCount = info.buttonCount;
    description.rendersForce = info.rendersForce;
    description.sensesRotation = info.sensesRotation;
    description.hasPedal = info.hasPedal;
    description.isInToothFrame = info.isInToothFrame;
    description.drivesServoRate = device.drivesServoRate();
    return description;
}

std::optional<DeviceInfo> infoFrom(const DeviceDescription& description) {
    DeviceInfo info;
    info.name = textIn(description.name);
    info.limits = description.limits;
    info.poseLimits = description.poseLimits;
    info.workspace = vectorFrom(description.workspace);
    if (description.hasWorkspaceCentre != 0) info.workspaceCentre = vectorFrom(description.workspaceCentre);
    info.stiffness = description.stiffness;
    info.buttonCount = std::max(0, description.buttonCount);
    info.rendersForce = description.rendersForce != 0;
    info.sensesRotation = description.sensesRotation != 0;
    info.hasPedal = description.hasPedal != 0;
    info.isInToothFrame = description.isInToothFrame != 0;
    const bool isUsable = isValid(info.limits) && isValid(info.poseLimits) && info.workspace.allFinite() &&
                          info.stiffness > 0 && vectorFrom(description.workspaceCentre).allFinite();
    return isUsable ? std::optional(info) : std::nullopt;
}

HandText handTextOf(const Message& message) {
    HandText text;
    put(message.in(Language::English), text.english);
    put(message.in(Language::Japanese), text.japanese);
    return text;
}

std::optional<Message> messageFrom(const HandText& text) {
    if (text.english.front() == 0) return std::nullopt;
    return Message::bilingual(textIn(text.english), textIn(text.japanese));
}

PoseMessage poseMessageOf(const DeviceSample& sample) {
    PoseMessage message;
    message.position = numbersOf(sample.hand.position);
    const Quat& turn = sample.hand.rotation;
    message.rotation = {turn.w(), turn.x(), turn.y(), turn.z()};
    message.pedal = sample.pedal;
    message.motorTemperature = sample.motorTemperature;
    message.buttons = sample.buttons;
    message.connected = sample.connected ? 1 : 0;
    return message;
}

DeviceSample sampleFrom(const PoseMessage& message) {
    DeviceSample sample;
    sample.hand.position = vectorFrom(message.position);
    const auto& [w, x, y, z] = message.rotation;
    sample.hand.rotation = Quat(w, x, y, z);
    sample.pedal = message.pedal;
    sample.motorTemperature = message.motorTemperature;
    sample.buttons = message.buttons;
    sample.connected = message.connected != 0;
    return sample;
}

ForceMessage forceMessageOf(const SafeWrench& wrench) {
    ForceMessage message;
    message.force = numbersOf(wrench.force());
    message.torque = numbersOf(wrench.torque());
    return message;
}

Wrench wrenchFrom(const ForceMessage& message) { return {vectorFrom(message.force), vectorFrom(message.torque)}; }

}  // namespace tactooth
