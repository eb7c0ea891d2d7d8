// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/exercise_controller.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/controllers/file_dialogs.h"
#include "app/gui/controllers/tooth_controller.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/model/examination_mode.h"
#include "app/gui/model/exercise_tooth.h"
#include "app/gui/model/own_exercises.h"
#include "app/gui/panels/exercise_panel.h"
#include "app/gui/panels/force_panel.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/scene/session_scene.h"
#include "app/gui/scene/surface_line.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/translation.h"
#include "assessment/cavity_view.h"
#include "assessment/exercise_file.h"
#include "assessment/ideal_shape.h"
#include "assessment/practice_report.h"
#include "geometry/util/byte_text.h"
#include "session/model/file_writer.h"

namespace tactooth {

ExerciseController::ExerciseController(SessionModel& model, const ExaminationMode& mode, const WindowPanels& panels,
                                       WindowMessages& messages, FileDialogs& files, FileWriter& writer,
                                       ToothController& teeth)
    : model_(model), mode_(mode), panels_(panels), messages_(messages), files_(files), writer_(writer), teeth_(teeth) {
    connect(panels_.inspection, &InspectionPanel::targetRequested, this, &ExerciseController::askForTarget);
    connect(panels_.exercise, &ExercisePanel::chosen, this, &ExerciseController::start);
    connect(panels_.exercise, &ExercisePanel::openRequested, this, &ExerciseController::askForExercise);
    connect(panels_.exercise, &ExercisePanel::restartRequested, this, [this] { model_.resetTooth(); });
    connect(panels_.exercise, &ExercisePanel::exportRequested, this, &ExerciseController::askForReportFile);
    connect(&teeth_, &ToothController::exerciseFileChosen, this, &ExerciseController::open);
    connect(&teeth_, &ToothController::loadingFailed, this, &ExerciseController::showActive);
    connect(&teeth_, &ToothController::loadingDeclined, this, &ExerciseController::showActive);
}

const std::vector<std::shared_ptr<const Exercise>>& ExerciseController::known() const {
    return panels_.exercise->known();
}

void ExerciseController::start(const std::shared_ptr<const Exercise>& exercise) {
    if (exercise == nullptr && !mode_.allowsAnotherTooth()) return showActive();  // the task of an examination stays
    panels_.exercise->show(exercise);
    if (exercise == nullptr) return clearTarget();
    teeth_.make([exercise](const ShareDone& progress) { return makeSessionTooth(exercise, progress); },
                tr("Preparing the exercise: %1…").arg(exerciseTitle(*exercise)));
}

void ExerciseController::open(const QString& file) {
    files_.enterFolderOf(file);
    Expected<Exercise> read = readExercise(file.toStdString());
    if (!read) return messages_.showError(read.error());
    emit fileOpened(file);
    start(std::make_shared<const Exercise>(std::move(*read)));
}

void ExerciseController::addOwn() {
    const OwnExercises own = readOwnExercises(ownExerciseFolder());
    for (const auto& exercise : own.exercises) add(exercise);
    if (!own.faults.empty()) messages_.setHint(QString::fromStdString(own.faults.front().in(windowLanguage())));
}

void ExerciseController::add(const std::shared_ptr<const Exercise>& exercise) { panels_.exercise->add(exercise); }

void ExerciseController::remove(const std::shared_ptr<const Exercise>& exercise) { panels_.exercise->remove(exercise); }

void ExerciseController::takeTooth() {
    clock_.restart();
    clearTarget();
    active_ = exerciseOf(*model_.tooth());
    const auto* plan = active_ != nullptr ? std::get_if<PreparationPlan>(&active_->ideal) : nullptr;
    if (plan != nullptr) panels_.view->measureTool().setAxis(plan->outward);
    panels_.force->wantDepthStop(plan != nullptr && plan->stopsDevice);
    showActive();
    showZones();
    emit activeChanged();
}

/// Where nothing may be cut.
void ExerciseController::showZones() {
    OutlineMarks marks;
    for (std::size_t i = 0; active_ != nullptr && i < active_->forbidden.size(); ++i) {
        const ForbiddenZone& zone = active_->forbidden[i];
        const auto outer = model_.tooth()->piece->tooth().ownOuter();
        marks.lines.push_back({.kind = OutlineMarks::Kind::Forbidden,
                               .places = lineOnSurface(zone.corners, zone.outward, true, outer),
                               .outward = zone.outward});
    }
    panels_.view->outlines().setMarks(OutlineOverlay::Layer::Exercise, std::move(marks));
}

void ExerciseController::beginExercise() {
    const QString target = QString::fromStdString(model_.tooth()->work.targetFile);
    if (active_ == nullptr) {
        if (!target.isEmpty()) openTarget(target);  // of a saved tooth
        return;
    }
    showCavity();
    prepareHand();
    loadIdealShape();
}

/// One that is pending will be opened anew.
ExerciseController::TargetState ExerciseController::targetState() const {
    if (!openedFile_.isEmpty()) return {{}, openedFile_};
    return {target_, targetFile_};
}

void ExerciseController::restore(TargetState state) {
    if (state.target.metrics != nullptr) {
        if (active_ != nullptr) state.target.name = exerciseTitle(*active_);  // in the language of this window
        setTarget(std::move(state.target));
        targetFile_ = state.file;
    } else if (!state.file.isEmpty()) {
        openTarget(state.file);
    } else if (active_ != nullptr) {
        loadIdealShape();
    }
}

void ExerciseController::showActive() { panels_.exercise->show(active_); }

/// Turns the picture as the exercise asks, or so that nothing hides the cavity.
void ExerciseController::showCavity() {
    const auto show = [this](const ViewDirection& view) {
        panels_.view->setView(OrbitCamera::Direction{view.azimuth, view.elevation});
    };
    const auto* plan = std::get_if<PreparationPlan>(&active_->ideal);
    switch (active_->view) {
        case StartView::Cavity:
            if (plan != nullptr) show(viewOnto(*plan, model_.tooth()->piece->tooth(), model_.mesialX()));
            return;
        case StartView::Dentist:
            return panels_.view->setView(defaultView(model_));
        case StartView::Mirror:
            panels_.view->setView(defaultView(model_));
            return panels_.view->takeParkedMirror();
        case StartView::Occlusal:
            return panels_.view->setView(StandardView::Occlusal);
        case StartView::Buccal:
            return panels_.view->setView(StandardView::Buccal);
        case StartView::Lingual:
            return panels_.view->setView(StandardView::Lingual);
        case StartView::Mesial:
            return panels_.view->setView(StandardView::Mesial);
        case StartView::Distal:
            return panels_.view->setView(StandardView::Distal);
    }
}

/// The bur stands as in the plan, and stops at its depth.
void ExerciseController::prepareHand() {
    const auto* plan = std::get_if<PreparationPlan>(&active_->ideal);
    if (plan == nullptr) return;
    MouseManipulator& hand = model_.manipulator();
    hand.alignShaft(plan->outward);
    panels_.force->setDepth(plan->depth);
    panels_.force->setFlatFloor(plan->isFlat);
    hand.depthControl().setReference(plan->isFlat ? floorReference(*plan, model_.tooth()->piece->tooth())
                                                  : std::nullopt);
}

void ExerciseController::loadIdealShape() {
    messages_.setHint(tr("Preparing the target of %1…").arg(exerciseTitle(*active_)));
    openedFile_.clear();
    prepare([exercise = active_, name = exerciseTitle(*active_), tooth = model_.tooth()->piece->volume().tooth(),
             box = model_.tooth()->box()](const TargetProgress& progress) -> Expected<Target> {
        Expected<TriangleMesh> ideal = idealShape(*exercise, tooth);
        if (!ideal) return Unexpected{ideal.error()};
        return makeTarget(name, std::move(*ideal), *tooth->ownOuter(), box, progress);
    });
}

void ExerciseController::openTarget(const QString& file) {
    if (!model_.tooth()) return;
    files_.enterFolderOf(file);
    messages_.setHint(tr("Measuring the distance to %1…").arg(QFileInfo(file).fileName()));
    openedFile_ = file;
    prepare([file, outer = model_.tooth()->piece->tooth().ownOuter(),
             box = model_.tooth()->box()](const TargetProgress& progress) -> Expected<Target> {
        Expected<TriangleMesh> ideal = tactooth::loadIdealShape(file.toStdString());
        if (!ideal) return Unexpected{ideal.error()};
        return makeTarget(QFileInfo(file).fileName(), std::move(*ideal), *outer, box, progress);
    });
}

void ExerciseController::prepare(std::function<Expected<Target>(const TargetProgress& progress)> make) {
    prepared_ = std::make_shared<std::atomic<double>>(0);
    pendingTarget_.start(
        [make = std::move(make), share = prepared_] { return make([&](double done) { *share = done; }); });
}

std::optional<LongWork> ExerciseController::preparing() {
    if (!isBusy()) return std::nullopt;
    return LongWork{.title = tr("Preparing the target"),
                    .share = prepared_->load(),
                    .cancel = [this] { cancelPreparing(); },
                    .cancelTip = tr("The tooth and the target stay as they are")};
}

void ExerciseController::cancelPreparing() {
    pendingTarget_.cancel();
    openedFile_.clear();
    messages_.setHint(target_.metrics != nullptr ? tr("It was cancelled: the target before stays")
                                                 : tr("It was cancelled: there is no target"));
}

/// The user's own target takes the place of the exercise.
void ExerciseController::leaveExercise() {
    active_ = nullptr;
    panels_.force->wantDepthStop(false);
    showActive();
    showZones();
    emit activeChanged();
}

void ExerciseController::clearTarget() {
    pendingTarget_.cancel();
    openedFile_.clear();
    targetFile_.clear();
    setTarget({});
    leaveExercise();
}

void ExerciseController::setTarget(Target target) {
    target_ = std::move(target);
    progress_.restart(target_.metrics);
    model_.aids().setWalls(target_.guideWalls);
    showTarget();
}

void ExerciseController::showTarget() {
    if (!mode_.showsTarget()) return panels_.inspection->setTarget({});
    panels_.inspection->setTarget(target_);
    if (active_ != nullptr && target_.metrics != nullptr) panels_.inspection->ghostAction()->setChecked(true);
}

void ExerciseController::collectTarget() {
    auto target = pendingTarget_.poll();
    if (!target) return;
    const QString file = std::exchange(openedFile_, QString());
    if (!*target) return messages_.showError(target->error());
    if (!file.isEmpty()) leaveExercise();
    targetFile_ = file;
    setTarget(std::move(**target));
    if (active_ == nullptr) {
        if (mode_.showsTarget())
            messages_.setHint(
                tr("Blue: still to cut. White: as the target. Orange: cut too deep. Strongest at 0.5 mm."));
        return;
    }
    messages_.setHint(QString::fromStdString(active_->words(windowLanguage()).task));
}

void ExerciseController::poll() {
    collectTarget();
    const LiveRunner* runner = model_.runner();
    if (runner != nullptr && model_.log().workSeconds() == 0) clock_.restart();  // the tooth was put back
    if (runner == nullptr || target_.metrics == nullptr) return progress_.update(nullptr, 0);
    progress_.update(runner->feed().surface(), total(runner->feed().removed()));
}

void ExerciseController::showProgress() {
    if (model_.runner() == nullptr) return;
    panels_.exercise->show(workSeconds(), model_.runner()->feed().removed(), model_.runner()->feed().materials(),
                           progress_.progress());
}

double ExerciseController::workSeconds() const { return clock_.seconds(model_.log().workSeconds()); }

void ExerciseController::stopClock() { clock_.stop(model_.log().workSeconds()); }

void ExerciseController::continueClock() { clock_.goOn(model_.log().workSeconds()); }

void ExerciseController::askForTarget() {
    files_.open(tr("Target: the ideal shape, in the frame of the tooth"),
                tr("Surfaces and saved teeth (*.stl *.STL *.obj *.ply *.tactooth);;All files (*)"),
                [this](const QString& file) { openTarget(file); });
}

void ExerciseController::askForExercise() {
    files_.open(tr("Open exercise"), tr("Exercises (*.toml);;All files (*)"),
                [this](const QString& file) { open(file); });
}

void ExerciseController::askForReportFile() {
    files_.save(tr("Report of what was done"), tr("Table (*.csv)"), "report.csv",
                [this](const QString& file) { exportReport(file); });
}

void ExerciseController::exportReport(const QString& file) {
    if (model_.runner() == nullptr) return;
    files_.enterFolderOf(file);
    const std::string report = practiceReportCsv({.tooth = model_.tooth()->name,
                                                  .task = target_.name.toStdString(),
                                                  .seconds = workSeconds(),
                                                  .cavity = progress_.progress(),
                                                  .removed = model_.runner()->feed().removed(),
                                                  .materials = &model_.runner()->feed().materials(),
                                                  .beside = model_.runner()->feed().loss().beside,
                                                  .events = model_.log().events().all()});
    writer_.write([report, path = file.toStdString()](
                      const GoesOn& goesOn) { return writeInPieces(path, asBytes(report), goesOn); },
                  [this, file](const Expected<bool>& written) {
                      messages_.showWritten(written, tr("The report was written to %1").arg(file));
                  });
}

}  // namespace tactooth
