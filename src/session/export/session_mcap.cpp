// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/export/session_mcap.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>
#include <utility>

#include "session/export/mcap_writer.h"
#include "session/export/session_moments.h"
#include "session/recording/session_replay.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNanoseconds = 1e9;  // in a second

Json numberSchema(const char* description) { return {{"type", "number"}, {"description", description}}; }

Json objectSchema(const Json& properties) { return {{"type", "object"}, {"properties", properties}}; }

Json vectorSchema(const char* unit, bool isRotation = false) {
    Json properties = Json::object();
    for (const char* axis : {"x", "y", "z"}) properties[axis] = numberSchema(unit);
    if (isRotation) properties["w"] = numberSchema(unit);
    return objectSchema(properties);
}

/// The time and the frame, which each message has, and more.
std::string schemaOf(const char* title, const Json& more) {
    Json properties = {
        {"timestamp", objectSchema({{"sec", {{"type", "integer"}, {"minimum", 0}}},
                                    {"nsec", {{"type", "integer"}, {"minimum", 0}, {"maximum", 999999999}}}})},
        {"frame_id", {{"type", "string"}, {"description", "Frame of reference: tooth, in mm"}}}};
    properties.update(more);
    Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
    schema.update(objectSchema(properties));
    return schema.dump();
}

Json vectorJson(const Vec3& v) { return {{"x", v.x()}, {"y", v.y()}, {"z", v.z()}}; }

Json poseJson(const Pose& pose) {
    const Quat& q = pose.rotation;
    return {{"position", vectorJson(pose.position)},
            {"orientation", {{"x", q.x()}, {"y", q.y()}, {"z", q.z()}, {"w", q.w()}}}};
}

/// ns since 1970 of "2026-11-26T12:00:00Z"; 0 for another form.
std::uint64_t nanosecondsOf(const std::string& date) {
    std::tm utc{};
    if (std::sscanf(date.c_str(), "%d-%d-%dT%d:%d:%d", &utc.tm_year, &utc.tm_mon, &utc.tm_mday, &utc.tm_hour,
                    &utc.tm_min, &utc.tm_sec) != 6) {
        return 0;
    }
    utc.tm_year -= 1900;
    utc.tm_mon -= 1;
    const std::time_t seconds = ::timegm(&utc);
    constexpr std::time_t kYear2500 = 16'725'225'600;  // ns of later years do not fit
    return seconds > 0 && seconds < kYear2500 ? static_cast<std::uint64_t>(seconds) * 1'000'000'000U : 0;
}

/// The channels of the file.
class SessionChannels {
public:
    SessionChannels(McapWriter writer, std::uint64_t start, double rateHz)
        : writer_(std::move(writer)), start_(start), period_(1 / rateHz) {
        const Json pose = objectSchema({{"position", vectorSchema("mm")}, {"orientation", vectorSchema("", true)}});
        pose_ = writer_.addChannel("/tool/pose", "foxglove.PoseInFrame",
                                   schemaOf("foxglove.PoseInFrame", {{"pose", pose}}));
        force_ = writer_.addChannel(
            "/tool/force", "tactooth.Force",
            schemaOf("tactooth.Force", {{"force", vectorSchema("N, before the limits of the device")},
                                        {"torque", vectorSchema("N*mm")},
                                        {"depth", numberSchema("of the hand in the tooth, mm")},
                                        {"contacts", {{"type", "integer"}}}}));
        spindle_ = writer_.addChannel("/spindle", "tactooth.Spindle",
                                      schemaOf("tactooth.Spindle", {{"speed", numberSchema("rev/min")},
                                                                    {"load", numberSchema("N*mm")},
                                                                    {"power", numberSchema("of the removal, W")},
                                                                    {"pedal", numberSchema("0 up, 1 down")},
                                                                    {"cutting", {{"type", "boolean"}}}}));
        events_ =
            writer_.addChannel("/events", "tactooth.Event",
                               schemaOf("tactooth.Event", {{"event", {{"type", "string"}}},
                                                           {"place", vectorSchema("tip of the bur, mm")},
                                                           {"removed", numberSchema("mm^3; negative: put back")}}));
    }

    void onTick(double time, const Tick& tick) {
        if (time < next_) return;
        next_ = std::max(next_ + period_, time + period_ / 2);
        write(pose_, time, {{"pose", poseJson(tick.contact.proxy)}});
        write(force_, time,
              {{"force", vectorJson(tick.force.wrench.force)},
               {"torque", vectorJson(tick.force.wrench.torque)},
               {"depth", tick.contact.depth},
               {"contacts", tick.contact.triangles}});
        write(spindle_, time,
              {{"speed", tick.spindle.speedRpm},
               {"load", tick.spindle.load},
               {"power", tick.spindle.removalPower},
               {"pedal", tick.input.pedal},
               {"cutting", tick.input.cutting}});
    }
    /// A moment is known only after the ticks of its time, so a chunk of their own has them.
    void endTicks() { writer_.endChunk(); }
    void write(const SessionMoment& moment) {
        Json json = {{"event", moment.what}};
        if (moment.place) json["place"] = vectorJson(*moment.place);
        if (moment.removed) json["removed"] = *moment.removed;
        write(events_, moment.time, json);
    }
    [[nodiscard]] std::uint64_t messages() const { return messages_; }
    [[nodiscard]] Expected<void> commit() { return writer_.commit(); }

private:
    void write(McapWriter::ChannelId channel, double seconds, const Json& more) {
        const auto time = start_ + static_cast<std::uint64_t>(std::llround(seconds * kNanoseconds));
        Json json = {{"timestamp", {{"sec", time / 1'000'000'000U}, {"nsec", time % 1'000'000'000U}}},
                     {"frame_id", "tooth"}};
        json.update(more);
        writer_.write(channel, time, json.dump(-1, ' ', false, Json::error_handler_t::replace));
        ++messages_;
    }

    McapWriter writer_;
    std::uint64_t start_;  // ns
    double period_;        // s
    double next_ = 0;      // s
    std::uint64_t messages_ = 0;
    McapWriter::ChannelId pose_ = 0, force_ = 0, spindle_ = 0, events_ = 0;
};

}  // namespace

Expected<McapExport> exportMcap(const SessionRecording& recording, const std::filesystem::path& path, double rateHz) {
    Expected<McapWriter> writer = McapWriter::create(path, "Tactooth");
    if (!writer) return Unexpected{writer.error()};
    SessionChannels channels(std::move(*writer), nanosecondsOf(recording.facts().date), rateHz);
    Expected<SessionReplay> replay = SessionReplay::start(recording);
    if (!replay) return Unexpected{replay.error()};
    SessionMoments moments(*replay);
    const auto onTick = [&](double time, const Tick& tick) {
        channels.onTick(time, tick);
        moments.onTick(time, tick);
    };
    const auto onEvent = [&](double time, const SessionEvent& event) { moments.onEvent(time, event); };
    if (auto played = replay->playUntil({}, onTick, onEvent); !played) return Unexpected{played.error()};
    moments.finish();
    channels.endTicks();
    for (const SessionMoment& moment : moments.all()) channels.write(moment);
    if (auto done = channels.commit(); !done) return Unexpected{done.error()};
    return McapExport{replay->seconds(), channels.messages(), replay->differsAt()};
}

}  // namespace tactooth
