// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/finish/finished_work.h"

#include <QDateTime>
#include <algorithm>
#include <chrono>
#include <optional>
#include <system_error>
#include <utility>

#include "app/common/report/make_report.h"
#include "app/common/report/preparation_parts.h"
#include "app/common/report/report_font.h"
#include "assessment/ideal_shape.h"
#include "assessment/rubric/exercise_rubric.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "session/recording/recording_folder.h"
#include "session/recording/session_recording.h"
#include "session/track/make_track.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr auto kRecordingName = "recording.ttsession";
constexpr auto kToothName = "tooth.tactooth";
constexpr double kReplayed = 0.5, kIdealMade = 0.6;  // about these shares of the time

/// What the recording of a work shows.
struct Recorded {
    std::shared_ptr<SessionTrack> track;  // null: not known
    std::string date;
};

/// Copies the recording, which may go on later, and replays it.
Recorded replay(WorkAssessment& assessment, AssessmentProgress& progress) {
    Recorded recorded;
    if (assessment.work.recording.empty()) return recorded;
    const fs::path copy = fs::path(assessment.folder.path().toStdString()) / kRecordingName;
    std::error_code fault;
    if (!fs::copy_file(assessment.work.recording, copy, fault)) return recorded;
    assessment.recording = copy;
    const Expected<SessionRecording> recording = SessionRecording::open(copy);
    if (!recording) return recorded;
    recorded.date = recording->facts().date;
    const auto model = recording->makeModel();
    if (!model) return recorded;
    const auto track = emptyTrack(*recording, **model);
    if (!track) return recorded;
    progress.follow(*track, kReplayed);
    makeTrack(*recording, *model, **track, progress.stopToken());
    progress.follow(nullptr, 0);
    const bool isTheWork = !(*track)->fault() && !(*track)->differsAt();
    if (isTheWork) recorded.track = *track;
    assessment.canReplay = isTheWork;
    return recorded;
}

Expected<AssessedWork> assessedWork(const FinishedWork& finished) {
    const Exercise& exercise = *finished.exercise;
    const auto uncut = exerciseTooth(exercise);
    if (!uncut) return Unexpected{uncut.error()};
    Expected<TriangleMesh> ideal = idealShape(exercise, *uncut);
    if (!ideal) return Unexpected{ideal.error()};
    AssessedWork work;
    work.student = finished.title;
    setExercise(work, exercise);
    Preparation& preparation = work.preparation;
    preparation.original = (*uncut)->ownOuter();
    preparation.mesialX = (*uncut)->toothContext().mesialX;
    preparation.ideal = std::make_shared<const SurfacePart>(std::move(*ideal));
    preparation.prepared = std::make_shared<const SurfacePart>(asReadFromFile(*finished.cut));
    preparation.tooth = (*uncut)->layers().empty() ? finished.uncut : *uncut;
    addPulps(preparation);
    addNeighbours(preparation, *finished.uncut, *finished.cut);
    preparation.gums = exerciseGums(exercise);
    const auto* plan = std::get_if<PreparationPlan>(&exercise.ideal);
    preparation.axis = plan != nullptr ? plan->outward : openingOf(preparation);
    return work;
}

/// English where no font has the letters.
Language reportLanguage(const FinishedWork& finished) {
    return reportFont(finished.language) ? finished.language : Language::English;
}

/// A folder that is not there yet.
fs::path freeFolder(const fs::path& in, const std::string& name) {
    std::error_code ignored;
    fs::path folder = in / name;
    for (int number = 2; fs::exists(folder, ignored); ++number) {
        folder = in / (name + " (" + std::to_string(number) + ")");
    }
    return folder;
}

}  // namespace

double AssessmentProgress::share() const {
    const std::lock_guard lock(mutex_);
    if (track_ == nullptr || track_->expectedSeconds() <= 0) return share_;
    return upTo_ * std::min(1.0, track_->seconds() / track_->expectedSeconds());
}

void AssessmentProgress::follow(std::shared_ptr<const SessionTrack> track, double upTo) {
    const std::lock_guard lock(mutex_);
    track_ = std::move(track);
    upTo_ = upTo;
}

Expected<std::shared_ptr<const WorkAssessment>> assessWork(FinishedWork work, AssessmentProgress& progress) {
    using Result = std::shared_ptr<const WorkAssessment>;
    const auto assessment = std::make_shared<WorkAssessment>();
    assessment->work = std::move(work);
    assessment->work.toothFile = std::exchange(assessment->work.makeToothFile, nullptr)();
    const FinishedWork& finished = assessment->work;
    Expected<Rubric> found = rubricOf(*finished.exercise);
    if (!found) return Unexpected{found.error()};
    assessment->rubric = std::move(*found);
    const Recorded recorded = replay(*assessment, progress);
    if (progress.stopToken().stop_requested()) return Result();
    progress.setShare(kReplayed);
    Expected<AssessedWork> assessed = assessedWork(finished);
    if (!assessed) return Unexpected{assessed.error()};
    assessed->track = recorded.track;
    assessed->date =
        recorded.date.empty() ? QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString() : recorded.date;
    if (progress.stopToken().stop_requested()) return Result();
    assessed->progress = [&](double share) { progress.setShare(kIdealMade + (1 - kIdealMade) * share); };
    assessed->progress(0);
    Expected<AssessmentReport> report = makeReport(*assessed, assessment->rubric, reportLanguage(finished));
    if (!report) return Unexpected{report.error()};
    assessment->report = std::move(*report);
    return Result(assessment);
}

Expected<fs::path> handInWork(const WorkAssessment& assessment, const HandIn& handIn, const GoesOn& goesOn) {
    constexpr double kReport = 0.8, kTooth = 0.9;  // about these shares of the time: the report has pictures
    if (!goesOn(0)) return fs::path();
    AssessmentReport report = assessment.report;
    report.name = handIn.name;
    report.comment = handIn.comment;
    const std::string title = report.expert + (handIn.name.empty() ? "" : ", " + handIn.name);
    const fs::path folder = freeFolder(handIn.folder, recordingName(std::chrono::system_clock::now(), title));
    FileTransaction files;
    if (auto made = files.makeFolder(folder); !made) return Unexpected{made.error()};
    std::vector<fs::path> outputs(kReportFiles.begin(), kReportFiles.end());
    outputs.emplace_back(kToothName);
    if (!assessment.recording.empty()) outputs.emplace_back(kRecordingName);
    for (const fs::path& name : outputs) {
        if (auto opened = files.open(folder / name); !opened) return Unexpected{opened.error()};
    }
    if (auto done = writeReport(folder, report); !done) return Unexpected{done.error()};
    if (!goesOn(kReport)) return fs::path();
    if (auto done = writeFile(folder / kToothName, assessment.work.toothFile); !done) return Unexpected{done.error()};
    if (!goesOn(kTooth)) return fs::path();
    if (!assessment.recording.empty()) {
        const auto bytes = readFile(assessment.recording);
        if (!bytes) return Unexpected{bytes.error()};
        if (auto done = writeFile(folder / kRecordingName, bytes->bytes()); !done) return Unexpected{done.error()};
    }
    if (!goesOn(1)) return fs::path();
    if (auto named = files.commit(); !named) return Unexpected{named.error()};
    return folder;
}

}  // namespace tactooth
