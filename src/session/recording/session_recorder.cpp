// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/session_recorder.h"

#include <pthread.h>

#include <algorithm>
#include <condition_variable>
#include <utility>

#include "geometry/files/file_bytes.h"
#include "geometry/util/assert.h"
#include "journal/format/attachment.h"
#include "session/recording/event_codec.h"
#include "session/recording/messages.h"
#include "session/recording/session_setup.h"
#include "session/recording/session_text.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;

constexpr auto kDrainPeriod = 50ms;   // the queues hold four seconds
constexpr auto kBlockPeriod = 450ms;  // a block is at most half a second
constexpr double kBlockSeconds = 0.45;
constexpr auto kMirrorPeriod = 16ms;  // a picture

std::vector<std::byte> bytesOf(const std::string& text) {
    const std::span<const std::byte> bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

std::uint32_t ticksIn(std::span<const SessionEvent> events) {
    return static_cast<std::uint32_t>(
        std::ranges::count_if(events, [](const SessionEvent& event) { return secondsOf(event).has_value(); }));
}

}  // namespace

SessionRecorder::SessionRecorder(std::unique_ptr<JournalWriter> writer)
    : writer_(std::move(writer)),
      flushed_(std::chrono::steady_clock::now()),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

Expected<std::unique_ptr<SessionRecorder>> SessionRecorder::create(const std::filesystem::path& path,
                                                                   const CutModel& model, const std::string& title,
                                                                   std::shared_ptr<const SigningKey> seal,
                                                                   const RecordingPart& part) {
    Expected<std::unique_ptr<JournalFile>> file = createJournalFile(path);
    if (!file) return Unexpected{file.error()};
    return start(std::move(*file), displayName(path), model, title, std::move(seal), part);
}

Expected<std::unique_ptr<SessionRecorder>> SessionRecorder::start(std::unique_ptr<JournalFile> file,
                                                                  const std::string& name, const CutModel& model,
                                                                  const std::string& title,
                                                                  std::shared_ptr<const SigningKey> seal,
                                                                  const RecordingPart& part) {
    const std::string header = recordingHeader(model, title, seal != nullptr ? &seal->publicKey() : nullptr, part);
    JournalWriter::Options options;
    options.seal = std::move(seal);
    Expected<std::unique_ptr<JournalWriter>> writer = JournalWriter::start(std::move(file), name, header, options);
    if (!writer) return Unexpected{writer.error()};
    auto recorder = std::unique_ptr<SessionRecorder>(new SessionRecorder(std::move(*writer)));
    recorder->attachTooth(model);
    return recorder;
}

void SessionRecorder::attachTooth(const CutModel& model) {
    if (model.tooth().isTouchOnly()) {
        attach(kTouchedAttachment, touchedBytes(model.tooth()));
    } else {
        attach(kToothAttachment, toothFileBytes(model, {}));
    }
    for (std::size_t i = 0; i < model.surroundings().size(); ++i) {
        attach(surroundingAttachment(i), surroundingBytes(*model.surroundings()[i]));
    }
}

SessionRecorder::~SessionRecorder() {
    end();
    thread_ = {};  // joins
}

void SessionRecorder::attach(std::string_view name, std::span<const std::byte> content) {
    if (!attached_.insert(std::string(name)).second) return;
    for (JournalBlock& block : attachmentBlocks(name, content)) (void)writer_->appendWhenRoom(std::move(block));
}

void SessionRecorder::note(const std::string& json) {
    (void)writer_->appendWhenRoom({BlockType::Note, firstTick_, 0, bytesOf(json)});
}

void SessionRecorder::describe(const std::string& work) {
    attach(workAttachment(descriptions_++), std::as_bytes(std::span(work)));
}

void SessionRecorder::open(const BeginEvent& event) {
    end();
    {
        const std::lock_guard lock(mutex_);
        isBeyondGap_ = isBeyondGap_ || overflowed_;
    }
    if (isBeyondGap_) return;
    const MeshAttachment bur = attachmentOf(event.instrument.shape->mesh());
    attach(bur.name, bur.content);
    const std::lock_guard lock(mutex_);
    note(setupText(event, bur.name));
}

std::shared_ptr<EventLanes> SessionRecorder::begin(const BeginEvent& event) {
    open(event);
    const std::lock_guard lock(mutex_);
    lanes_ = std::make_shared<EventLanes>();
    return lanes_;
}

void SessionRecorder::noteMirror(const MirrorSight& sight, std::chrono::steady_clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (mirrorNow_ && (sight == *mirrorNow_ || now - mirrorNoted_ < kMirrorPeriod)) return;
    mirrorNow_ = sight;
    mirrorNoted_ = now;
    const std::uint64_t tick = firstTick_ + ticksIn(events_);
    if (!mirror_.empty() && mirror_.back().tick == tick) mirror_.pop_back();  // no tick has seen it
    mirror_.push_back({tick, sight});
}

void SessionRecorder::append(const SessionEvent& event) {
    if (const auto* const begin = std::get_if<BeginEvent>(&event)) return open(*begin);
    const std::lock_guard lock(mutex_);
    TACTOOTH_ASSERT(lanes_ == nullptr);
    events_.push_back(event);
    unwritten_ += secondsOf(event).value_or(0);
    if (unwritten_ >= kBlockSeconds || events_.size() >= kMaxBlockEvents) writeEvents(/*waits=*/true);
}

void SessionRecorder::end() {
    const std::lock_guard lock(mutex_);
    if (lanes_ == nullptr) return writeEvents(/*waits=*/true);
    drain();
    writeEvents(/*waits=*/false);
    lanes_.reset();
    merger_ = {};
}

/// Called with the lock.
void SessionRecorder::drain() {
    lanes_->drain(merger_);
    merger_.take(events_);
    if (isBeyondGap_) return events_.clear();
    overflowed_ = overflowed_ || lanes_->hasOverflowed();
}

/// Called with the lock.
void SessionRecorder::writeEvents(bool waits) {
    flushed_ = std::chrono::steady_clock::now();
    unwritten_ = 0;
    std::span<const SessionEvent> rest = events_;
    while (!rest.empty()) {
        const std::span<const SessionEvent> block = rest.first(std::min(rest.size(), kMaxBlockEvents));
        rest = rest.subspan(block.size());
        const std::uint32_t ticks = ticksIn(block);
        if (!writeBlock({BlockType::Events, firstTick_, ticks, encodeEvents(block)}, waits)) break;
        writeMirror(ticks, waits);
        firstTick_ += ticks;
        hasChanges_ = hasChanges_ || std::ranges::any_of(block, changesTooth);
    }
    events_.clear();
}

/// Called with the lock. What the next `ticks` have seen; what none has seen yet waits.
void SessionRecorder::writeMirror(std::uint32_t ticks, bool waits) {
    const auto later =
        std::ranges::find_if(mirror_, [&](const MirrorMoment& each) { return each.tick >= firstTick_ + ticks; });
    const std::span<const MirrorMoment> seen(mirror_.begin(), later);
    if (seen.empty()) return;
    (void)writeBlock({BlockType::Mirror, firstTick_, ticks, encodeMirror(seen)}, waits);
    mirror_.erase(mirror_.begin(), later);
}

/// Called with the lock. A block that finds no room is a gap, beyond which nothing can be replayed.
bool SessionRecorder::writeBlock(JournalBlock block, bool waits) {
    if (waits ? writer_->appendWhenRoom(std::move(block)) : writer_->append(std::move(block))) return true;
    overflowed_ = isBeyondGap_ = true;
    return false;
}

void SessionRecorder::breakOff() {
    const std::lock_guard lock(mutex_);
    if (lanes_ != nullptr) drain();
    writeEvents(/*waits=*/false);
    isBrokenOff_ = isBeyondGap_ = true;
}

bool SessionRecorder::isWhole() const {
    const std::lock_guard lock(mutex_);
    return !overflowed_ && !isBrokenOff_ && !writer_->fault();
}

bool SessionRecorder::hasChanges() const {
    const std::lock_guard lock(mutex_);
    return hasChanges_;
}

void SessionRecorder::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "recorder");  // for debuggers and profilers
    std::condition_variable_any wake;
    std::mutex sleeping;
    while (!stop.stop_requested()) {
        {
            const std::lock_guard lock(mutex_);
            if (lanes_ != nullptr) {
                drain();
                if (std::chrono::steady_clock::now() - flushed_ >= kBlockPeriod) writeEvents(/*waits=*/false);
            }
        }
        std::unique_lock lock(sleeping);
        (void)wake.wait_for(lock, stop, kDrainPeriod, [] { return false; });
    }
}

Expected<void> SessionRecorder::flush() {
    const Expected<void> flushed = writer_->flush();
    if (!flushed) return flushed;
    if (const std::optional<Message> why = fault()) return Unexpected{Error(*why)};
    return {};
}

Expected<void> SessionRecorder::close(std::uint64_t toothHash) {
    end();
    const bool hasGap = overflowed_ || isBrokenOff_;
    note(endText(hasGap ? RecordedEnd{.hasGap = true} : RecordedEnd{.toothHash = toothHash}));
    const Expected<void> closed = writer_->close(firstTick_);
    if (!closed) return closed;
    if (overflowed_) return unexpected(msg::kRecordingOverflowed);
    return {};
}

std::optional<Message> SessionRecorder::fault() const {
    const std::lock_guard lock(mutex_);
    if (std::optional<Message> stopped = writer_->fault()) return stopped;
    if (overflowed_) return Message(msg::kRecordingOverflowed);
    return std::nullopt;
}

}  // namespace tactooth
