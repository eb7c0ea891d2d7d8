// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "session/model/next_part.h"
#include "session/model/task.h"
#include "session/recording/kept_recording.h"

namespace tactooth {

/// Keeps a recording of the session that runs, one file for each tooth. What takes time (writing the tooth, waiting for
/// the disk) is done in the background. All functions are for one thread.
class SessionKeeper {
public:
    explicit SessionKeeper(const TaskExecutor& executor = runInThread)
        : executor_(executor), beginning_(executor), next_(executor) {}
    /// As finish().
    ~SessionKeeper();
    SessionKeeper(const SessionKeeper&) = delete;
    SessionKeeper& operator=(const SessionKeeper&) = delete;

    /// Where the recordings of the next teeth go; none: nothing is recorded, and a recording that runs ends. No thread
    /// works on the tooth then. `seal`: signs the recordings; null: nobody does.
    void setFolder(std::optional<RecordingFolder> folder, std::shared_ptr<const SigningKey> seal = {});
    [[nodiscard]] const std::optional<RecordingFolder>& folder() const { return folder_; }
    /// Hears where a recording is in the end; another thread may call it.
    using Kept = std::function<void(const std::filesystem::path& file)>;
    /// `ending`: called when a recording ends; what it returns is called when the file has its final name, and not if
    /// nothing was kept. Null: nobody wants to know.
    void setEnding(std::function<Kept()> ending) { ending_ = std::move(ending); }
    /// What somebody is doing (workText), if it has changed: recordings hold it.
    void describe(const std::string& work);

    /// Prepares for work on `tooth`, on which no thread works yet. If its recording runs already, that goes on;
    /// otherwise the one before ends, and another one begins. `work`: what was done with it before (workText).
    void prepare(const std::shared_ptr<const CutModel>& tooth, const std::string& title, const std::string& work);
    /// The next call of `prepare` begins another recording, even for the same tooth.
    void forget() { tooth_.reset(); }
    /// Whether the threads may begin: the recording has, or there is none.
    [[nodiscard]] bool isReady();

    /// Whether the recording has stopped, but its next part can begin.
    [[nodiscard]] bool canBeginPart();
    /// Whether it should not wait for a moment at which the hand rests.
    [[nodiscard]] bool isPartOverdue() const { return next_.isOverdue(); }
    /// Begins the next part with the tooth as it is. It was reopened (CutModel::reopen), and no thread works on it.
    /// `before`: its time and events so far, and whether it has unsaved cuts. `history`: of the tooth.
    void beginPart(const SessionWork& before, const CutHistory& history);
    /// Before the user takes something back: where a replay of this recording could not, it ends here, and its next
    /// part can begin when that is done.
    void allow(Edit edit, const CutHistory& history);
    /// Whether a part has begun after a fault, once.
    [[nodiscard]] bool takeResumed() { return std::exchange(isResumed_, false); }

    /// A bur begins to work with the tooth; null: nothing is recorded. The threads that work end before the next call
    /// of `begin`, `end` or `prepare`.
    [[nodiscard]] std::shared_ptr<EventLanes> begin(const BeginEvent& event);
    /// The threads have ended.
    void end();
    /// How the mirror is held now (SessionRecorder::noteMirror).
    void noteMirror(const MirrorSight& sight);
    /// The instrument has touched something.
    void noteTouch();
    /// Ends the recording and waits until it is on the disk.
    void finish();
    /// The file of the tooth's recording with all that has happened so far, on the disk: of the recording that runs,
    /// or of the one that ended last. Empty: nothing was recorded, or not all of it. No thread works on the tooth now.
    [[nodiscard]] std::filesystem::path writtenFile();

    [[nodiscard]] bool isRecording() const { return recording_ != nullptr && !hasStopped_; }
    /// Whether a recording runs that is signed.
    [[nodiscard]] bool isSealing() const { return isRecording() && recording_->isSealed(); }
    /// One sentence why recording has stopped or could not begin, once.
    [[nodiscard]] std::optional<Message> takeFault();

private:
    using Recording = std::shared_ptr<KeptRecording>;
    /// Faults of recordings that end in the background.
    struct Faults {
        std::mutex mutex;
        std::optional<Message> newest;
    };

    void endRecording();
    void finishStopped();
    void collect();
    void beginRecording(const std::shared_ptr<const CutModel>& tooth);

    TaskExecutor executor_;
    std::optional<RecordingFolder> folder_;
    std::shared_ptr<const SigningKey> seal_;
    std::string work_, title_;
    std::shared_ptr<const CutModel> tooth_;  // that was prepared
    RecordingPart part_;                     // of the tooth, the newest
    Recording recording_;                    // null: none
    Recording stopped_;                      // the part before, until the next one has begun
    bool hasStopped_ = false;                // it has a fault
    std::optional<Message> fault_;           // not taken yet
    std::shared_ptr<Faults> lateFaults_ = std::make_shared<Faults>();
    Task<Recording> beginning_;
    NextPart next_;
    bool isPart_ = false;            // the newest recording has begun in mid-session
    bool wasFaultReported_ = false;  // since the last part
    bool isResumed_ = false;         // not taken yet
    // The file of the tooth's recording that has ended; the thread that ends it shares it.
    std::shared_ptr<std::filesystem::path> endedFile_ = std::make_shared<std::filesystem::path>();
    std::function<Kept()> ending_;
    std::jthread closing_;  // waits for the disk
};

}  // namespace tactooth
