// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/session_recording.h"

#include <algorithm>
#include <string>
#include <utility>

#include "session/recording/event_codec.h"
#include "session/recording/messages.h"
#include "session/recording/session_setup.h"

namespace tactooth {
namespace {

constexpr std::size_t kMaxBurBytes = std::size_t{64} << 20;

std::string textOf(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

SessionRecording::SessionRecording(JournalReader journal, RecordingFacts facts)
    : journal_(std::move(journal)), facts_(std::move(facts)) {}

Expected<SessionRecording> SessionRecording::open(const std::filesystem::path& path) {
    Expected<JournalReader> journal = JournalReader::open(path);
    if (!journal) return Unexpected{journal.error()};
    Expected<RecordingFacts> facts = parseHeader(journal->headerJson(), journal->name());
    if (!facts) return Unexpected{facts.error()};
    return SessionRecording(std::move(*journal), std::move(*facts));
}

std::uint64_t SessionRecording::ticks() const {
    const std::optional<TickRange> range = journal_.ticks();
    return range ? range->end - range->begin : 0;
}

/// A surface that is only touched has no file of a tooth.
Expected<std::shared_ptr<CutModel>> SessionRecording::makeTouched() const {
    const Expected<std::vector<std::byte>> bytes = readAttachment(journal_, kTouchedAttachment);
    if (!bytes) return Unexpected{bytes.error()};
    std::optional<LayeredTooth> tooth = touchedOf(*bytes, *facts_.materials);
    if (!tooth) return unexpected(msg::kRecordingSurfaceDamaged, journal_.name());
    constexpr double kVoxel = 0.05;  // mm: of a volume that is never cut
    return std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*tooth)), kVoxel);
}

Expected<double> SessionRecording::seconds() const {
    double seconds = 0;
    const auto read = forEach([&](const SessionEvent& event) {
        seconds += secondsOf(event).value_or(0);
        return true;
    });
    if (!read) return Unexpected{read.error()};
    return seconds;
}

Expected<std::shared_ptr<CutModel>> SessionRecording::makeModel() const {
    if (facts_.touchesOnly) return makeTouched();
    const Expected<std::vector<std::byte>> bytes = readAttachment(journal_, kToothAttachment);
    if (!bytes) return Unexpected{bytes.error()};
    Expected<OpenedTooth> tooth = parseTooth(*bytes, journal_.name(), *facts_.materials);
    if (!tooth) return Unexpected{tooth.error()};
    Surroundings bodies;
    for (std::size_t i = 0; i < facts_.surroundings; ++i) {
        const Expected<std::vector<std::byte>> body = readAttachment(journal_, surroundingAttachment(i));
        if (!body) return Unexpected{body.error()};
        bodies.push_back(surroundingOf(*body));
        if (bodies.back() == nullptr) return unexpected(msg::kRecordingBodyDamaged, journal_.name(), i + 1);
    }
    tooth->piece->surroundBy(std::move(bodies));
    return tooth->piece;
}

std::optional<SessionWork> SessionRecording::work() const {
    std::optional<SessionWork> last;
    for (std::size_t i = 0;; ++i) {
        const Expected<std::vector<std::byte>> text = readAttachment(journal_, workAttachment(i), kMaxWorkBytes);
        if (!text) return last;
        std::optional<SessionWork> work = parseWork(textOf(*text));
        if (!work) continue;
        if (last) {
            work->seconds = last->seconds;
            work->events = std::move(last->events);
            work->isUnsaved = last->isUnsaved;
        }
        last = std::move(work);
    }
}

Expected<bool> SessionRecording::hasChanges() const {
    bool isChanged = false;
    const Expected<void> read = forEach([&](const SessionEvent& event) {
        isChanged = changesTooth(event);
        return !isChanged;
    });
    if (!read) return Unexpected{read.error()};
    return isChanged;
}

Expected<BeginEvent> SessionRecording::beginEvent(const std::string& setup) const {
    const MeshFinder findMesh = [this](const std::string& name) -> std::optional<TriangleMesh> {
        const Expected<std::vector<std::byte>> content = readAttachment(journal_, name, kMaxBurBytes);
        return content ? meshOf(*content) : std::nullopt;
    };
    return parseSetup(setup, *facts_.materials, findMesh, journal_.name());
}

Expected<void> SessionRecording::forEach(const std::function<bool(const SessionEvent&)>& visit) const {
    for (const BlockPlace& block : journal_.blocks()) {
        if (block.header.type != BlockType::Note && block.header.type != BlockType::Events) continue;
        const Expected<std::vector<std::byte>> payload = journal_.payload(block);
        if (!payload) return Unexpected{payload.error()};
        if (block.header.type == BlockType::Note) {
            const std::string text = textOf(*payload);
            if (parseEnd(text)) continue;
            const Expected<BeginEvent> begin = beginEvent(text);
            if (!begin) return Unexpected{begin.error()};
            if (!visit(*begin)) return {};
            continue;
        }
        const std::optional<std::vector<SessionEvent>> events = decodeEvents(*payload);
        if (!events) return unexpected(msg::kRecordingEventsDamaged, journal_.name(), block.offset);
        if (!std::ranges::all_of(*events, visit)) return {};
    }
    return {};
}

Expected<std::vector<MirrorMoment>> SessionRecording::mirror() const {
    constexpr std::size_t kMost = std::size_t{1} << 22;  // 19 hours of movement
    std::vector<MirrorMoment> all;
    for (const BlockPlace& block : journal_.blocks()) {
        if (block.header.type != BlockType::Mirror) continue;
        const Expected<std::vector<std::byte>> payload = journal_.payload(block);
        if (!payload) return Unexpected{payload.error()};
        const std::optional<std::vector<MirrorMoment>> moments = decodeMirror(*payload);
        const bool isInOrder = moments && (all.empty() || moments->empty() || all.back().tick <= moments->front().tick);
        if (!isInOrder || all.size() + moments->size() > kMost)
            return unexpected(msg::kRecordingEventsDamaged, journal_.name(), block.offset);
        all.insert(all.end(), moments->begin(), moments->end());
    }
    return all;
}

Expected<RecordedEnd> SessionRecording::end() const {
    RecordedEnd end;
    for (const BlockPlace& block : journal_.blocks()) {
        if (block.header.type != BlockType::Note) continue;
        const Expected<std::vector<std::byte>> payload = journal_.payload(block);
        if (!payload) return Unexpected{payload.error()};
        if (const auto found = parseEnd(textOf(*payload))) end = *found;
    }
    return end;
}

}  // namespace tactooth
