// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTemporaryDir>
#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

#include "assessment/exercise.h"
#include "assessment/report/assessment_report.h"
#include "session/model/file_writer.h"
#include "session/track/session_track.h"

namespace tactooth {

/// The work on an exercise as it was when the student finished it.
struct FinishedWork {
    std::shared_ptr<const Exercise> exercise;   ///< never null
    std::string title;                          ///< of the tooth, for people
    std::shared_ptr<const LayeredTooth> uncut;  ///< the tooth of the session
    std::shared_ptr<const Surface> cut;
    std::function<std::vector<std::byte>()> makeToothFile;  ///< it reads the tooth
    std::vector<std::byte> toothFile = {};                  ///< the saved tooth, as soon as it is made
    std::filesystem::path recording;        ///< with all of the work; it may go on later. Empty: there is none.
    Language language = Language::English;  ///< of the report
};

/// How far an assessment has come, and the wish to end it. Any thread.
class AssessmentProgress {
public:
    /// 0..1
    [[nodiscard]] double share() const;
    void setShare(double share) { share_ = share; }
    /// Until the next call of setShare, the share follows this track from 0 to `upTo`; null: it follows none.
    void follow(std::shared_ptr<const SessionTrack> track, double upTo);

    void stop() { stop_.request_stop(); }
    [[nodiscard]] std::stop_token stopToken() const { return stop_.get_token(); }

private:
    std::atomic<double> share_{0};
    std::stop_source stop_;
    mutable std::mutex mutex_;  // of the next two
    std::shared_ptr<const SessionTrack> track_;
    double upTo_ = 0;
};

/// A work with its mark.
struct WorkAssessment {
    FinishedWork work;
    Rubric rubric;
    AssessmentReport report;          ///< by `rubric`
    std::filesystem::path recording;  ///< a copy as of the moment of finishing; empty: there is none
    bool canReplay = false;           ///< the recording leads to the same tooth
    QTemporaryDir folder = {};        ///< of the copy
};

/// Assesses a work as the command `assess` does with its recording, or with its saved tooth. Takes some seconds: run it
/// in a Task. Fails with one sentence. Null if `progress` was stopped.
[[nodiscard]] Expected<std::shared_ptr<const WorkAssessment>> assessWork(FinishedWork work,
                                                                         AssessmentProgress& progress);

/// What a student hands in with the work.
struct HandIn {
    std::string name;              ///< of the student; may be empty
    std::string comment;           ///< of the teacher; may be empty
    std::filesystem::path folder;  ///< in which the new one is made
};

/// Writes the report in its four forms, the saved tooth, and the recording if there is one, into a new folder: all of
/// them, or nothing. Returns that folder; an empty one if it was given up. Fails with one sentence.
[[nodiscard]] Expected<std::filesystem::path> handInWork(const WorkAssessment& assessment, const HandIn& handIn,
                                                         const GoesOn& goesOn);

}  // namespace tactooth
