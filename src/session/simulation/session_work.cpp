// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/session_work.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxEvents = 10'000;
constexpr std::size_t kMaxTextBytes = 4096;  // as long as a path may be
constexpr double kMaxSeconds = 1e7;          // some months
constexpr double kMaxPlace = 1e4;            // mm

constexpr std::pair<const char*, std::string SessionWork::*> kTexts[] = {{"title", &SessionWork::title},
                                                                         {"exercise", &SessionWork::exercise},
                                                                         {"exercise_file", &SessionWork::exerciseFile},
                                                                         {"target_file", &SessionWork::targetFile},
                                                                         {"bur", &SessionWork::bur},
                                                                         {"bur_file", &SessionWork::burFile}};
constexpr std::string SessionWork::*kFiles[] = {&SessionWork::exerciseFile, &SessionWork::targetFile,
                                                &SessionWork::burFile};

Json jsonOf(const CutEvent& event) {
    Json json = {{"what", cutEventName(event.kind)},
                 {"t", event.time},
                 {"x", event.place.x()},
                 {"y", event.place.y()},
                 {"z", event.place.z()}};
    if (event.isTakenBack) json["taken_back"] = true;
    return json;
}

const Json* valueOf(const Json& json, const char* key) {
    const auto found = json.is_object() ? json.find(key) : json.end();
    return found != json.end() ? &*found : nullptr;
}

std::optional<double> numberOf(const Json& json, const char* key, double most) {
    const Json* const value = valueOf(json, key);
    if (value == nullptr || !value->is_number()) return std::nullopt;
    const double number = value->get<double>();
    return std::abs(number) <= most ? std::optional(number) : std::nullopt;
}

bool isTrue(const Json& json, const char* key) {
    const Json* const value = valueOf(json, key);
    return value != nullptr && value->is_boolean() && value->get<bool>();
}

std::optional<CutEvent> eventOf(const Json& json) {
    const Json* const what = valueOf(json, "what");
    if (what == nullptr || !what->is_string()) return std::nullopt;
    const auto kind = std::ranges::find_if(
        kCutEventKinds, [&](CutEventKind one) { return cutEventName(one) == what->get_ref<const std::string&>(); });
    const auto time = numberOf(json, "t", kMaxSeconds);
    const auto x = numberOf(json, "x", kMaxPlace), y = numberOf(json, "y", kMaxPlace),
               z = numberOf(json, "z", kMaxPlace);
    if (kind == kCutEventKinds.end() || !time || !x || !y || !z) return std::nullopt;
    return CutEvent{*kind, *time, Vec3(*x, *y, *z), isTrue(json, "taken_back")};
}

std::vector<CutEvent> eventsOf(const Json& json) {
    std::vector<CutEvent> events;
    const Json* const list = valueOf(json, "events");
    if (list == nullptr || !list->is_array()) return events;
    for (const Json& one : *list) {
        const auto event = eventOf(one);
        // They rise in time, as CutEvents reports them.
        if (event && (events.empty() || event->time >= events.back().time)) events.push_back(*event);
        if (events.size() == kMaxEvents) break;
    }
    return events;
}

}  // namespace

std::string workText(const SessionWork& work) {
    Json json = Json::object();
    for (const auto& [key, place] : kTexts) {
        if (!(work.*place).empty()) json[key] = work.*place;
    }
    if (work.mouthTooth != 0) json["mouth_tooth"] = work.mouthTooth;
    json["seconds"] = work.seconds;
    if (work.isUnsaved) json["unsaved"] = true;
    json["events"] = Json::array();
    for (const CutEvent& event : work.events) json["events"].push_back(jsonOf(event));
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string workTextWithoutFolders(SessionWork work) {
    for (const auto place : kFiles) work.*place = std::filesystem::path(work.*place).filename().string();
    work.isUnsaved = false;
    return workText(work);
}

std::optional<SessionWork> parseWork(std::string_view text) {
    if (text.size() > kMaxWorkBytes) return std::nullopt;
    const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
    if (!json.is_object()) return std::nullopt;
    SessionWork work;
    for (const auto& [key, place] : kTexts) {
        const Json* const value = valueOf(json, key);
        const bool isText = value != nullptr && value->is_string();
        if (isText && value->get_ref<const std::string&>().size() <= kMaxTextBytes)
            work.*place = value->get<std::string>();
    }
    constexpr int kLastTooth = 48;
    work.mouthTooth = static_cast<int>(std::max(0.0, numberOf(json, "mouth_tooth", kLastTooth).value_or(0)));
    work.seconds = std::max(0.0, numberOf(json, "seconds", kMaxSeconds).value_or(0));
    work.isUnsaved = isTrue(json, "unsaved");
    work.events = eventsOf(json);
    if (!work.events.empty()) work.seconds = std::max(work.seconds, work.events.back().time);
    return work;
}

}  // namespace tactooth
