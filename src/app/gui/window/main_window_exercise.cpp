// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be cut, and how well it was.
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <cmath>

#include "app/gui/panels/exercise_panel.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/translation.h"
#include "app/gui/window/main_window.h"
#include "assessment/exercise_file.h"
#include "assessment/ideal_shape.h"
#include "assessment/practice_report.h"
#include "geometry/files/atomic_file.h"

namespace tactooth {
namespace {

constexpr qint64 kMetricsMs = 300;  // a student looks up from the tooth no more often

}  // namespace

void MainWindow::connectExercise() {
    connect(inspectionPanel_, &InspectionPanel::targetRequested, this, &MainWindow::askForTarget);
    connect(exercise_, &ExercisePanel::chosen, this, &MainWindow::startExercise);
    connect(exercise_, &ExercisePanel::openRequested, this, &MainWindow::askForExercise);
    connect(exercise_, &ExercisePanel::restartRequested, this, [this] { model_.resetTooth(); });
    connect(exercise_, &ExercisePanel::exportRequested, this, &MainWindow::askForReportFile);
}

void MainWindow::startExercise(const std::shared_ptr<const Exercise>& exercise) {
    exercise_->show(exercise);
    if (exercise == nullptr) return clearTarget();
    status_->setHint(tr("Preparing the exercise: %1…").arg(translated(exercise->name)));
    model_.load(Task<SessionTooth>::Function([exercise] { return makeSessionTooth(exercise); }));
}

void MainWindow::openExercise(const QString& file) {
    folder_ = QFileInfo(file).absolutePath();
    Expected<Exercise> read = readExercise(file.toStdString());
    if (!read) return showError(read.error());
    remember(file);
    startExercise(std::make_shared<const Exercise>(std::move(*read)));
}

/// Turns the picture to the side that is worked on.
void MainWindow::showCavityOf(const Exercise& exercise) {
    const auto* plan = std::get_if<PreparationPlan>(&exercise.ideal);
    if (plan == nullptr) return;
    const Vec3& outward = plan->outward;
    const double mesial = model_.mesialX() * outward.x();
    if (std::abs(outward.y()) > std::max(outward.z(), std::abs(mesial))) {
        view_->setView(outward.y() > 0 ? StandardView::Buccal : StandardView::Lingual);
    } else if (std::abs(mesial) > outward.z()) {
        view_->setView(mesial > 0 ? StandardView::Mesial : StandardView::Distal);
    }
}

void MainWindow::loadIdealShapeOf(const std::shared_ptr<const Exercise>& exercise) {
    pendingTarget_.start([exercise, name = translated(exercise->name), tooth = model_.tooth()->piece->volume().tooth(),
                          box = model_.tooth()->box()]() -> Expected<Target> {
        Expected<TriangleMesh> ideal = idealShape(*exercise, tooth);
        if (!ideal) return Unexpected{ideal.error()};
        return makeTarget(name, std::move(*ideal), *tooth->ownOuter(), box);
    });
}

/// The work of another window goes on as it was seen there.
void MainWindow::restoreViewState(ViewState viewState) {
    view_->setOrbitCamera(viewState.eye);
    if (viewState.target.metrics != nullptr) {
        if (activeExercise_ != nullptr)
            viewState.target.name = translated(activeExercise_->name);  // in the language of this window
        setTarget(std::move(viewState.target));
        targetFile_ = viewState.targetFile;
    } else if (activeExercise_ != nullptr) {
        loadIdealShapeOf(activeExercise_);
    } else if (!viewState.targetFile.isEmpty()) {
        openTarget(viewState.targetFile);
    }
    inspectionPanel_->choose(viewState.inside);
}

void MainWindow::openTarget(const QString& file) {
    if (!model_.tooth()) return;
    folder_ = QFileInfo(file).absolutePath();
    status_->setHint(tr("Measuring the distance to %1…").arg(QFileInfo(file).fileName()));
    activeExercise_ = nullptr;
    exercise_->show(activeExercise_);
    targetFile_ = file;
    pendingTarget_.start(
        [file, outer = model_.tooth()->piece->tooth().ownOuter(), box = model_.tooth()->box()]() -> Expected<Target> {
            Expected<TriangleMesh> ideal = loadIdealShape(file.toStdString());
            if (!ideal) return Unexpected{ideal.error()};
            return makeTarget(QFileInfo(file).fileName(), std::move(*ideal), *outer, box);
        });
}

void MainWindow::clearTarget() {
    pendingTarget_.cancel();
    activeExercise_ = nullptr;
    targetFile_.clear();
    setTarget({});
}

void MainWindow::setTarget(Target target) {
    pendingProgress_.cancel();
    progress_.reset();
    measuredSurface_.reset();
    target_ = std::move(target);
    inspectionPanel_->setTarget(target_);
}

void MainWindow::collectTarget() {
    auto target = pendingTarget_.poll();
    if (!target) return;
    if (!*target) {
        if (target_.metrics == nullptr) targetFile_.clear();
        return showError(target->error());
    }
    setTarget(std::move(**target));
    if (activeExercise_ == nullptr) {
        status_->setHint(tr("Blue: still to cut. White: as the target. Orange: cut too deep. Strongest at 0.5 mm."));
        return;
    }
    inspectionPanel_->ghostAction()->setChecked(true);
    status_->setHint(translated(activeExercise_->task));
}

/// Counts anew when the tooth has changed, in a thread of its own.
void MainWindow::updateMetrics() {
    if (auto progress = pendingProgress_.poll()) progress_ = **progress;
    if (target_.metrics == nullptr || target_.metrics->empty() || model_.simulator() == nullptr) return;
    if (pendingProgress_.isBusy() || (sinceMetrics_.isValid() && sinceMetrics_.elapsed() < kMetricsMs)) return;
    const std::shared_ptr<const Surface> tooth = model_.simulator()->surface();
    if (tooth == measuredSurface_) return;
    measuredSurface_ = tooth;
    sinceMetrics_.start();
    pendingProgress_.start([metrics = target_.metrics, tooth, removed = total(model_.simulator()->removed())] {
        return Expected<CavityProgress>(metrics->of(*tooth, removed));
    });
}

void MainWindow::askForTarget() {
    auto* dialog = new QFileDialog(this, tr("Target: the ideal shape, in the frame of the tooth"), folder_,
                                   tr("Surfaces and saved teeth (*.stl *.STL *.obj *.ply *.tactooth);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::openTarget);
    dialog->open();
}

void MainWindow::askForExercise() {
    auto* dialog = new QFileDialog(this, tr("Open exercise"), folder_, tr("Exercises (*.toml);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::openExercise);
    dialog->open();
}

void MainWindow::askForReportFile() {
    askWhereToWrite(tr("Report of what was done"), tr("Table (*.csv)"), "report.csv", &MainWindow::exportReportTo);
}

void MainWindow::exportReportTo(const QString& file) {
    if (model_.simulator() == nullptr) return;
    folder_ = QFileInfo(file).absolutePath();
    const std::string report = practiceReportCsv({.tooth = model_.tooth()->name,
                                                  .task = target_.name.toStdString(),
                                                  .seconds = model_.workSeconds(),
                                                  .cavity = progress_,
                                                  .removed = model_.simulator()->removed(),
                                                  .beside = model_.simulator()->loss().beside,
                                                  .events = model_.events().all()});
    const Expected<void> written = writeFile(file.toStdString(), report);
    if (!written) return showError(written.error());
    status_->setHint(tr("The report was written to %1").arg(file));
}

}  // namespace tactooth
