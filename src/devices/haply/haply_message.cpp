// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/haply/haply_message.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "devices/base/messages.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

using Json = nlohmann::json;

constexpr double kMillimetres = 1000;    // in a metre
constexpr double kFurthest = 1;          // m: an Inverse3 reaches 0.4 m; a larger number is not in metres
constexpr double kUnitTolerance = 0.02;  // of a quaternion's squared length: the service sends it as rounded text

// Made before any device runs, whose threads only hand their places on.
const Message kNoPlace(msg::kInverse3Lost);
const Message kNoPower(msg::kInverse3NoPower);
const Message kNotCalibrated(msg::kInverse3NotCalibrated);
const Message kNotReady(msg::kInverse3NotReady);
const Message kGripAsleep(msg::kGripAsleep);
const Message kGripBroken(msg::kGripBroken);

/// The member of an object; a null value if there is none.
const Json& member(const Json& object, const char* key) {
    static const Json kNone;
    if (!object.is_object()) return kNone;
    const auto found = object.find(key);
    return found == object.end() ? kNone : *found;
}

std::string textOf(const Json& value) { return value.is_string() ? value.get<std::string>() : std::string(); }

double numberOf(const Json& value) {
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

Vec3 vectorOf(const Json& value) {
    return {numberOf(member(value, "x")), numberOf(member(value, "y")), numberOf(member(value, "z"))};
}

/// True if the name can be put between quotes without escapes.
bool isPlain(const std::string& id) {
    return !id.empty() && std::ranges::all_of(id, [](unsigned char c) {
        return c == '-' || c == '_' || c == ':' || (c < 128 && std::isalnum(c) != 0);
    });
}

/// True only for an explicit false: a missing value counts as no fault.
bool isDenied(const Json& status, const char* key) {
    const Json& value = member(status, key);
    return value.is_boolean() && !value.get<bool>();
}

/// The rotation; no value if the four numbers are not a rotation.
std::optional<Quat> rotationOf(const Json& value) {
    const Quat rotation(numberOf(member(value, "w")), numberOf(member(value, "x")), numberOf(member(value, "y")),
                        numberOf(member(value, "z")));
    const bool isOne = std::abs(rotation.squaredNorm() - 1) < kUnitTolerance;
    return isOne ? std::optional(rotation.normalized()) : std::nullopt;
}

/// Buttons a, b, c, or button_0, button_1, ... of other grips.
std::uint32_t buttonsOf(const Json& value) {
    constexpr std::array<std::array<const char*, 2>, 4> kNames = {
        {{"a", "button_0"}, {"b", "button_1"}, {"c", "button_2"}, {"d", "button_3"}}};
    std::uint32_t buttons = 0;
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        for (const char* const name : kNames[i]) {
            const Json& down = member(value, name);
            if (down.is_boolean() && down.get<bool>()) buttons |= 1U << i;
        }
    }
    return buttons;
}

const Json* findIn(const Json& list, const std::string& id) {
    if (!list.is_array()) return nullptr;
    for (const Json& device : list) {
        if (textOf(member(device, "device_id")) == id) return &device;
    }
    return nullptr;
}

/// Parses the whole message. Every message of format 3 has a list of the devices.
Expected<Json> parsed(std::string_view message) {
    Json json = Json::parse(message, nullptr, false);
    if (json.is_discarded() || !json.is_object()) return unexpected(msg::kHaplyNoJson);
    const std::string version = textOf(member(json, "version"));
    if (!member(json, "inverse3").is_array() || (!version.empty() && version.substr(0, 2) != "3.")) {
        return unexpected(msg::kHaplyOtherVersion);
    }
    return json;
}

/// The `index`-th grip, those with a cable first; empty if there are fewer grips.
std::string gripAt(const Json& json, std::size_t index) {
    for (const char* const kind : {"verse_grip", "wireless_verse_grip"}) {
        const Json& list = member(json, kind);
        if (!list.is_array()) continue;
        if (index < list.size()) return textOf(member(list[index], "device_id"));
        index -= list.size();
    }
    return {};
}

const Message* faultIn(const Json& status) {
    if (isDenied(status, "power_supply")) return &kNoPower;
    if (isDenied(status, "calibrated")) return &kNotCalibrated;
    return isDenied(status, "ready") ? &kNotReady : nullptr;
}

void readGrip(const Json& json, const std::string& name, HaplyReading& reading) {
    if (name.empty()) return;
    const Json* grip = findIn(member(json, "verse_grip"), name);
    if (grip == nullptr) grip = findIn(member(json, "wireless_verse_grip"), name);
    if (grip == nullptr) return;
    reading.buttons = buttonsOf(member(member(*grip, "state"), "buttons"));
    if (reading.faultMessage == nullptr && isDenied(member(*grip, "status"), "awake"))
        reading.faultMessage = &kGripAsleep;
    const Json& orientation = member(member(*grip, "state"), "orientation");
    if (!orientation.is_object()) return;
    if (const std::optional<Quat> rotation = rotationOf(orientation)) {
        reading.hand.rotation = *rotation;
        reading.hasTurn = true;
    } else {
        reading.usable = false;
        if (reading.faultMessage == nullptr) reading.faultMessage = &kGripBroken;
    }
}

}  // namespace

Expected<std::vector<HaplyNames>> haplyDevices(std::string_view firstMessage) {
    const Expected<Json> json = parsed(firstMessage);
    if (!json) return Unexpected{json.error()};
    std::vector<HaplyNames> devices;
    for (const Json& device : member(*json, "inverse3")) {
        const std::string id = textOf(member(device, "device_id"));
        if (!isPlain(id)) return unexpected(msg::kHaplyOtherVersion);
        devices.push_back({id, gripAt(*json, devices.size())});
    }
    if (devices.empty()) {
        return unexpected(msg::kHaplyNoInverse3);
    }
    return devices;
}

Expected<HaplyNames> findHaply(std::string_view firstMessage, std::string_view wanted) {
    const Expected<std::vector<HaplyNames>> devices = haplyDevices(firstMessage);
    if (!devices) return Unexpected{devices.error()};
    std::string others;
    for (const HaplyNames& names : *devices) {
        if (wanted.empty() || names.device == wanted) return names;
        others += others.empty() ? names.device : ", " + names.device;
    }
    return unexpected(msg::kHaplyUnknownInverse3, wanted, others);
}

Expected<HaplyReading> readHaply(std::string_view message, const HaplyNames& names) {
    const Expected<Json> json = parsed(message);
    if (!json) return Unexpected{json.error()};
    const Json* const device = findIn(member(*json, "inverse3"), names.device);
    if (device == nullptr) return unexpected(msg::kInverse3Gone);
    const Json& place = member(member(*device, "state"), "cursor_position");
    if (!place.is_object()) return unexpected(msg::kHaplyOtherVersion);
    const Vec3 metres = vectorOf(place);
    if (metres.allFinite() && metres.cwiseAbs().maxCoeff() > kFurthest) return unexpected(msg::kHaplyOtherUnits);
    HaplyReading reading;
    reading.hand.position = kMillimetres * metres;
    reading.faultMessage = metres.allFinite() ? faultIn(member(*device, "status")) : &kNoPlace;
    reading.usable = reading.faultMessage == nullptr;
    readGrip(*json, names.grip, reading);
    return reading;
}

std::string haplyForce(const std::string& device, const Vec3& force) {
    return R"({"inverse3":[{"device_id":")" + device + R"(","commands":{"set_cursor_force":{"values":{"x":)" +
           numberText(force.x()) + R"(,"y":)" + numberText(force.y()) + R"(,"z":)" + numberText(force.z()) + "}}}}]}";
}

std::string haplyHandshake(const std::string& device) {
    std::string text = haplyForce(device, Vec3::Zero());
    text.replace(0, 1, R"({"session":{"configure":{"profile":{"name":"org.tactooth:tactooth"}}},)");
    return text;
}

}  // namespace tactooth
