// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "geometry/util/expected.h"
#include "journal/file/journal_writer.h"
#include "session/kernel/event_lanes.h"
#include "session/kernel/event_merger.h"
#include "session/kernel/session_event.h"
#include "session/recording/mirror_sight.h"
#include "session/recording/session_text.h"

namespace tactooth {

/// Ending of the files that hold a recorded session.
inline constexpr std::string_view kSessionFileEnding = ".ttsession";

/// Records a session into a file (docs/session-file.md): first the tooth, then all events, in blocks of half a second.
/// A thread of its own does the work; the threads of the simulation only leave their events in queues. All functions
/// are for one thread, where nothing else is said.
class SessionRecorder {
public:
    /// `model`: the tooth as it is now. For an exact replay nothing was cut since it was opened. `title`: of the tooth,
    /// for people. `seal`: signs the recording (docs/session-file.md); null: unsealed. Fails with one sentence if the
    /// file cannot be made.
    [[nodiscard]] static Expected<std::unique_ptr<SessionRecorder>> create(const std::filesystem::path& path,
                                                                           const CutModel& model,
                                                                           const std::string& title,
                                                                           std::shared_ptr<const SigningKey> seal = {},
                                                                           const RecordingPart& part = {});
    /// The same in a file that the caller has opened (createJournalFile); `name` stands for it in messages.
    [[nodiscard]] static Expected<std::unique_ptr<SessionRecorder>> start(
        std::unique_ptr<JournalFile> file, const std::string& name, const CutModel& model, const std::string& title,
        std::shared_ptr<const SigningKey> seal = {}, const RecordingPart& part = {});
    /// As after a crash, if `close` was not called: what has come is written, without a clean end.
    ~SessionRecorder();
    SessionRecorder(const SessionRecorder&) = delete;
    SessionRecorder& operator=(const SessionRecorder&) = delete;

    /// Notes what somebody is doing with the tooth (workText). The last one counts.
    void describe(const std::string& work);
    /// A bur begins to work. The threads of the simulation report to the result until `end`.
    [[nodiscard]] std::shared_ptr<EventLanes> begin(const BeginEvent& event);
    /// How the mirror is held now. Call it as often as the picture changes: it keeps what has changed, at most once in
    /// 16 ms. The moment is right to the period in which the queues are emptied, 0.05 s.
    void noteMirror(const MirrorSight& sight,
                    std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());
    /// For a session that is not live, in place of `begin`: takes the next event. Waits while the disk is slow.
    void append(const SessionEvent& event);
    /// The threads of the simulation have ended. Without a `begin` before, nothing happens.
    void end();
    /// Another part follows (RecordingPart): the recording ends here, though threads may still report to it. It can
    /// neither go on nor be replayed beyond this moment.
    void breakOff();
    /// Waits until all that has happened up to the last `end` is on the disk. Fails with the sentence of `fault`.
    [[nodiscard]] Expected<void> flush();
    /// Ends the recording and waits until it is on the disk. `toothHash`: of the tooth now (CutModel::hash); it does
    /// not count unless `isWhole`. Fails with the sentence of `fault`.
    [[nodiscard]] Expected<void> close(std::uint64_t toothHash);
    /// Whether the recording leads to the tooth as it is: it did not stop before. Any thread.
    [[nodiscard]] bool isWhole() const;

    /// One sentence why the recording has stopped; nothing as long as it goes on. Any thread.
    [[nodiscard]] std::optional<Message> fault() const;
    /// Whether the file takes no more: the disk or the folder has failed. Any thread.
    [[nodiscard]] bool hasFileFailed() const { return writer_->fault().has_value(); }
    /// Whether the tooth was changed in what was recorded so far. Any thread.
    [[nodiscard]] bool hasChanges() const;
    /// Size of the file. Any thread.
    [[nodiscard]] std::uint64_t bytes() const { return writer_->bytes(); }

private:
    explicit SessionRecorder(std::unique_ptr<JournalWriter> writer);
    void run(const std::stop_token& stop);
    void drain();
    void open(const BeginEvent& event);
    void writeEvents(bool waits);
    void writeMirror(std::uint32_t ticks, bool waits);
    [[nodiscard]] bool writeBlock(JournalBlock block, bool waits);
    void note(const std::string& json);
    void attach(std::string_view name, std::span<const std::byte> content);
    void attachTooth(const CutModel& model);

    std::unique_ptr<JournalWriter> writer_;
    std::set<std::string> attached_;  // names
    std::size_t descriptions_ = 0;
    mutable std::mutex mutex_;  // of all below
    std::shared_ptr<EventLanes> lanes_;
    EventMerger merger_;
    std::vector<SessionEvent> events_;  // not written yet
    std::uint64_t firstTick_ = 0;       // of these; the ticks of all burs are counted together
    std::vector<MirrorMoment> mirror_;  // not written yet
    std::optional<MirrorSight> mirrorNow_;
    std::chrono::steady_clock::time_point mirrorNoted_;
    double unwritten_ = 0;  // s of a session that is not live
    std::chrono::steady_clock::time_point flushed_;
    bool hasChanges_ = false;
    bool overflowed_ = false;  // events are missing
    bool isBrokenOff_ = false;
    bool isBeyondGap_ = false;  // what comes now leads nowhere
    std::jthread thread_;       // last: it uses the members above
};

}  // namespace tactooth
