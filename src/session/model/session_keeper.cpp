// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/session_keeper.h"

#include <utility>

namespace tactooth {

SessionKeeper::~SessionKeeper() { finish(); }

void SessionKeeper::setFolder(std::optional<RecordingFolder> folder, std::shared_ptr<const SigningKey> seal) {
    folder_ = std::move(folder);
    seal_ = std::move(seal);
    if (folder_) return;
    beginning_.cancel();
    next_.reset();
    endRecording();
    closing_ = {};  // joins: it reads the tooth, which may be cut further
}

void SessionKeeper::describe(const std::string& work) {
    if (work == work_) return;
    work_ = work;
    if (recording_ != nullptr && !hasStopped_) recording_->recorder().describe(work_);
}

void SessionKeeper::prepare(const std::shared_ptr<const CutModel>& tooth, const std::string& title,
                            const std::string& work) {
    if (tooth == tooth_) return;
    tooth_ = tooth;
    work_ = work;
    title_ = title;
    part_ = firstPart();
    next_.reset();
    isPart_ = wasFaultReported_ = isResumed_ = false;
    beginning_.cancel();
    endRecording();
    endedFile_ = std::make_shared<std::filesystem::path>();
    if (folder_) beginRecording(tooth);
}

void SessionKeeper::beginRecording(const std::shared_ptr<const CutModel>& tooth) {
    const std::filesystem::path before = stopped_ != nullptr ? stopped_->file() : std::filesystem::path();
    beginning_.start([folder = *folder_, tooth, title = title_, work = work_, seal = seal_, part = part_, before] {
        return KeptRecording::begin(folder, tooth, title, work, seal, part, before);
    });
}

bool SessionKeeper::canBeginPart() {
    if (!folder_ || tooth_ == nullptr || beginning_.isBusy()) return false;
    constexpr std::uint64_t kAtLeast = std::uint64_t{16} << 20;  // bytes: a large tooth, and some minutes of cutting
    return next_.isPossible(*folder_, kAtLeast);
}

void SessionKeeper::beginPart(const SessionWork& before, const CutHistory& history) {
    SessionWork work = parseWork(work_).value_or(SessionWork());
    work.seconds = before.seconds;
    work.events = before.events;
    work.isUnsaved = before.isUnsaved;
    work_ = workText(work);
    isPart_ = true;
    if (recording_ != nullptr) {  // until the next part has begun, a crash leaves this one
        ++part_.number;
        stopped_ = std::exchange(recording_, nullptr);
        hasStopped_ = false;
    }
    next_.begun(history);
    beginRecording(tooth_);
}

void SessionKeeper::allow(Edit edit, const CutHistory& history) {
    if (!isRecording() || next_.canReplay(edit, history)) return;
    recording_->recorder().breakOff();
    hasStopped_ = true;
    next_.wantNow();
}

/// Gives the part that has stopped its final name. Its fault was said already.
void SessionKeeper::finishStopped() {
    if (stopped_ == nullptr) return;
    closing_ = executor_([recording = std::exchange(stopped_, nullptr)] { (void)recording->finish().has_value(); });
}

/// Takes over a recording that has begun.
void SessionKeeper::collect() {
    std::optional<Expected<Recording>> begun = beginning_.poll();
    if (!begun) return;
    if (!*begun) {
        if (!std::exchange(wasFaultReported_, true)) fault_ = begun->error();
        return next_.wantWhenWritable();
    }
    recording_ = std::move(**begun);
    hasStopped_ = false;
    if (isPart_) recording_->noteTouch();  // it holds cuts that no other file may hold
    isResumed_ = std::exchange(wasFaultReported_, false);
    finishStopped();
    if (!folder_ || recording_->tooth() != tooth_.get()) endRecording();
}

bool SessionKeeper::isReady() {
    collect();
    return !beginning_.isBusy();
}

std::shared_ptr<EventLanes> SessionKeeper::begin(const BeginEvent& event) {
    collect();
    if (recording_ == nullptr || hasStopped_) return nullptr;
    return recording_->recorder().begin(event);
}

void SessionKeeper::end() {
    if (recording_ != nullptr) recording_->recorder().end();
}

void SessionKeeper::noteMirror(const MirrorSight& sight) {
    if (recording_ != nullptr && !hasStopped_) recording_->recorder().noteMirror(sight);
}

void SessionKeeper::noteTouch() {
    if (recording_ != nullptr) recording_->noteTouch();
}

void SessionKeeper::endRecording() {
    finishStopped();
    hasStopped_ = false;
    if (recording_ == nullptr) return;
    // The assignment waits for the one before, which has mostly ended long ago.
    closing_ = executor_([recording = std::exchange(recording_, nullptr), faults = lateFaults_, file = endedFile_,
                          kept = ending_ ? ending_() : Kept()] {
        const Expected<void> done = recording->finish();
        if (done) {
            *file = recording->file();
            if (kept && !file->empty()) kept(*file);
            return;
        }
        const std::lock_guard lock(faults->mutex);
        faults->newest = done.error();
    });
}

std::filesystem::path SessionKeeper::writtenFile() {
    collect();
    if (recording_ != nullptr) {
        const bool isWhole = !hasStopped_ && recording_->recorder().flush();
        return isWhole ? recording_->file() : std::filesystem::path();
    }
    closing_ = {};  // joins
    return *endedFile_;
}

void SessionKeeper::finish() {
    while (beginning_.isBusy()) {
        collect();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    endRecording();
    tooth_.reset();
    closing_ = {};
}

std::optional<Message> SessionKeeper::takeFault() {
    if (recording_ != nullptr && !hasStopped_) {
        if (std::optional<Message> fault = recording_->recorder().fault()) {
            hasStopped_ = true;
            if (!std::exchange(wasFaultReported_, true)) fault_ = std::move(fault);
            if (recording_->recorder().hasFileFailed()) {
                next_.wantWhenWritable();
            } else {
                next_.wantNow();
            }
        }
    }
    if (fault_) return std::exchange(fault_, std::nullopt);
    const std::lock_guard lock(lateFaults_->mutex);
    return std::exchange(lateFaults_->newest, std::nullopt);
}

}  // namespace tactooth
