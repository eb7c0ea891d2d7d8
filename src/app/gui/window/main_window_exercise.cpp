// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be cut, and how well it was.
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <cmath>

#include "app/gui/panels/exercise_panel.h"
#include "app/gui/panels/inside_panel.h"
#include "app/gui/window/main_window.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/words.h"
#include "geometry/files/atomic_file.h"
#include "assessment/exercise_file.h"
#include "assessment/ideal_shape.h"
#include "assessment/practice_report.h"

namespace tactooth {
namespace {

constexpr qint64 kAccountMs = 300;  // a student looks up from the tooth no more often

}  // namespace

void MainWindow::connectExercise() {
    connect(inside_, &InsidePanel::targetWanted, this, &MainWindow::askForTarget);
    connect(exercise_, &ExercisePanel::chosen, this, &MainWindow::practise);
    connect(exercise_, &ExercisePanel::openWanted, this, &MainWindow::askForExercise);
    connect(exercise_, &ExercisePanel::startAgainWanted, this, [this] { bench_.resetTooth(); });
    connect(exercise_, &ExercisePanel::exportWanted, this, &MainWindow::askForReportFile);
}

void MainWindow::practise(const std::shared_ptr<const Exercise>& exercise) {
    exercise_->show(exercise);
    if (exercise == nullptr) return dropTarget();
    status_->setHint(tr("Preparing the exercise: %1…").arg(translated(exercise->name)));
    bench_.bring(Errand<BenchTooth>::Work([exercise] { return makeBenchTooth(exercise); }));
}

void MainWindow::openExercise(const QString& file) {
    folder_ = QFileInfo(file).absolutePath();
    Expected<Exercise> read = readExercise(file.toStdString());
    if (!read) return complain(read.error());
    remember(file);
    practise(std::make_shared<const Exercise>(std::move(*read)));
}

/// Turns the picture to the side that is worked on.
void MainWindow::lookFor(const Exercise& exercise) {
    const auto* plan = std::get_if<PreparationPlan>(&exercise.ideal);
    if (plan == nullptr) return;
    const Vec3& outward = plan->outward;
    const double mesial = bench_.mesialX() * outward.x();
    if (std::abs(outward.y()) > std::max(outward.z(), std::abs(mesial))) {
        view_->look(outward.y() > 0 ? StandardView::Buccal : StandardView::Lingual);
    } else if (std::abs(mesial) > outward.z()) {
        view_->look(mesial > 0 ? StandardView::Mesial : StandardView::Distal);
    }
}

void MainWindow::bringIdealShape(const std::shared_ptr<const Exercise>& exercise) {
    comingTarget_.start([exercise, name = translated(exercise->name), tooth = bench_.tooth()->piece->volume().tooth(),
                         box = bench_.tooth()->box()]() -> Expected<Target> {
        Expected<TriangleMesh> ideal = idealShape(*exercise, tooth);
        if (!ideal) return Unexpected{ideal.error()};
        return makeTarget(name, std::move(*ideal), *tooth->ownOuter(), box);
    });
}

/// The work of another window goes on as it was seen there.
void MainWindow::takeLook(Look look) {
    view_->setEye(look.eye);
    if (look.target.account != nullptr) {
        if (practised_ != nullptr) look.target.name = translated(practised_->name);  // in the language of this window
        setTarget(std::move(look.target));
        targetFile_ = look.targetFile;
    } else if (practised_ != nullptr) {
        bringIdealShape(practised_);
    } else if (!look.targetFile.isEmpty()) {
        openTarget(look.targetFile);
    }
    inside_->choose(look.inside);
}

void MainWindow::openTarget(const QString& file) {
    if (!bench_.tooth()) return;
    folder_ = QFileInfo(file).absolutePath();
    status_->setHint(tr("Measuring the distance to %1…").arg(QFileInfo(file).fileName()));
    practised_ = nullptr;
    exercise_->show(practised_);
    targetFile_ = file;
    comingTarget_.start(
        [file, outer = bench_.tooth()->piece->tooth().ownOuter(), box = bench_.tooth()->box()]() -> Expected<Target> {
            Expected<TriangleMesh> ideal = loadIdealShape(file.toStdString());
            if (!ideal) return Unexpected{ideal.error()};
            return makeTarget(QFileInfo(file).fileName(), std::move(*ideal), *outer, box);
        });
}

void MainWindow::dropTarget() {
    comingTarget_.forget();
    practised_ = nullptr;
    targetFile_.clear();
    setTarget({});
}

void MainWindow::setTarget(Target target) {
    comingProgress_.forget();
    progress_.reset();
    accounted_.reset();
    target_ = std::move(target);
    inside_->setTarget(target_);
}

void MainWindow::takeTarget() {
    auto target = comingTarget_.poll();
    if (!target) return;
    if (!*target) {
        if (target_.account == nullptr) targetFile_.clear();
        return complain(target->error());
    }
    setTarget(std::move(**target));
    if (practised_ == nullptr) {
        status_->setHint(tr("Blue: still to cut. White: as the target. Orange: cut too deep. Strongest at 0.5 mm."));
        return;
    }
    inside_->ghostAction()->setChecked(true);
    status_->setHint(translated(practised_->task));
}

/// Counts anew when the tooth has changed, in a thread of its own.
void MainWindow::keepAccount() {
    if (auto progress = comingProgress_.poll()) progress_ = **progress;
    if (target_.account == nullptr || target_.account->empty() || bench_.simulator() == nullptr) return;
    if (comingProgress_.isBusy() || (sinceAccount_.isValid() && sinceAccount_.elapsed() < kAccountMs)) return;
    const std::shared_ptr<const Surface> tooth = bench_.simulator()->surface();
    if (tooth == accounted_) return;
    accounted_ = tooth;
    sinceAccount_.start();
    comingProgress_.start([account = target_.account, tooth, removed = total(bench_.simulator()->removed())] {
        return Expected<CavityProgress>(account->of(*tooth, removed));
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
    if (bench_.simulator() == nullptr) return;
    folder_ = QFileInfo(file).absolutePath();
    const std::string report = practiceReportCsv({.tooth = bench_.tooth()->name,
                                                  .task = target_.name.toStdString(),
                                                  .seconds = bench_.workSeconds(),
                                                  .cavity = progress_,
                                                  .removed = bench_.simulator()->removed(),
                                                  .beside = bench_.simulator()->loss().beside,
                                                  .events = bench_.events().all()});
    const Expected<void> written = writeFile(file.toStdString(), report);
    if (!written) return complain(written.error());
    status_->setHint(tr("The report was written to %1").arg(file));
}

}  // namespace tactooth
