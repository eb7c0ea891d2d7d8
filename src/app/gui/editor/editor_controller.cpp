// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/editor_controller.h"

#include <QDockWidget>
#include <QInputDialog>
#include <QMainWindow>
#include <QScrollArea>
#include <any>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/gui/controllers/exercise_controller.h"
#include "app/gui/controllers/file_dialogs.h"
#include "app/gui/controllers/tooth_controller.h"
#include "app/gui/controllers/unsaved_work.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/editor/editor_panel.h"
#include "app/gui/model/examination_mode.h"
#include "app/gui/model/exercise_tooth.h"
#include "app/gui/model/own_exercises.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/translation.h"
#include "assessment/cavity_view.h"
#include "assessment/exercise_writer.h"
#include "session/model/session_model.h"
#include "view/camera/orbit_camera.h"

namespace tactooth {
namespace {

constexpr int kUsualTooth = 36;

/// The purpose of a tooth that a draft is drawn on.
struct DraftTooth {};

bool isOfDraft(const SessionTooth& tooth) { return std::any_cast<DraftTooth>(&tooth.purpose) != nullptr; }

/// Whether two exercises have the same tooth, decay and all.
bool haveSameTooth(const Exercise& a, const Exercise& b) { return a.tooth == b.tooth && a.inMouth == b.inMouth; }

/// A file name of a title: without what file systems do not take.
std::string fileNameOf(const std::string& title) {
    constexpr std::string_view kRefused = "/\\:*?\"<>|";
    std::string name;
    for (const char letter : title) {
        const bool isControl = static_cast<unsigned char>(letter) < 0x20;
        name += isControl || kRefused.find(letter) != kRefused.npos ? '-' : letter;
    }
    return name + ".toml";
}

}  // namespace

EditorController::EditorController(const Parts& parts) : parts_(parts) {
    connect(&tool_, &OutlineTool::changed, this, &EditorController::followDraft);
    connect(&parts_.teeth, &ToothController::loadingFailed, this, [this] { pending_.reset(); });
    connect(&parts_.teeth, &ToothController::loadingDeclined, this, [this] { pending_.reset(); });
    connect(&parts_.mode, &ExaminationMode::changed, this, [this] {
        if (isEditing()) takeMouse();
    });
    parts_.unsaved.setOther({[this] { return isUnsaved(); },
                             [this](Function then, Function otherwise) { askToClose(std::move(then), otherwise); }});
}

EditorController::~EditorController() { parts_.panels.view->setSurfaceTool(nullptr); }

/// While the editor itself asks for a tooth, nothing of the draft is lost.
bool EditorController::isUnsaved() const { return draft_ && draft_->isModified() && !loadsOwn_; }

void EditorController::beginNew() {
    const int onBench = parts_.model.tooth() ? fdiOf(*parts_.model.tooth()) : 0;
    const int fdi = isPermanentTooth(onBench) ? onBench : kUsualTooth;
    const bool inMouth = parts_.model.tooth() && parts_.model.tooth()->mouthTooth != 0;
    begin(std::make_shared<const Exercise>(newExercise(fdi, inMouth)), false);
}

void EditorController::askForCopy() {
    QStringList titles;
    std::vector<std::shared_ptr<const Exercise>> known;
    int chosen = 0;
    for (const auto& exercise : parts_.exercise.known()) {
        if (exercise == nullptr) continue;
        if (exercise == parts_.exercise.active()) chosen = static_cast<int>(known.size());
        titles << QString("%1. %2").arg(titles.size() + 1).arg(exerciseTitle(*exercise));
        known.push_back(exercise);
    }
    auto* dialog = new QInputDialog(&parts_.window);
    dialog->setObjectName("copyExercise");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Edit a copy"));
    dialog->setLabelText(tr("Exercise to begin with:"));
    dialog->setComboBoxItems(titles);
    dialog->setTextValue(titles.at(chosen));
    connect(dialog, &QInputDialog::textValueSelected, this,
            [this, titles, known = std::move(known)](const QString& title) {
                const auto place = titles.indexOf(title);
                if (place >= 0) beginCopy(known[static_cast<std::size_t>(place)]);
            });
    dialog->open();
}

void EditorController::beginCopy(const std::shared_ptr<const Exercise>& exercise) { begin(exercise, true); }

void EditorController::begin(const std::shared_ptr<const Exercise>& exercise, bool isCopy) {
    if (parts_.mode.isOn()) {
        return parts_.messages.setHint(tr("An examination has begun: finish it before you make an exercise"));
    }
    parts_.unsaved.confirmDiscard([this, exercise, isCopy] {
        end();
        pending_ = exercise;
        isCopy_ = isCopy;
        load(*exercise);
    });
}

/// What was cut on the bench, in a trial or before, may be lost now: the user has agreed, or was informed.
void EditorController::load(const Exercise& exercise) {
    loaded_ = exercise;
    tooth_.reset();
    loadsOwn_ = true;
    if (parts_.model.runner() != nullptr) parts_.model.markSaved(parts_.model.runner()->feed().removed());
    auto copy = std::make_shared<Exercise>(exercise);
    if (copy->name.empty()) copy->name = tr("New exercise").toStdString();
    parts_.teeth.load(
        [copy = std::shared_ptr<const Exercise>(std::move(copy))]() -> Expected<SessionTooth> {
            Expected<SessionTooth> tooth = makeSessionTooth(copy);
            if (tooth) tooth->purpose = DraftTooth{};
            return tooth;
        },
        tr("Preparing the tooth of the exercise…"));
    loadsOwn_ = false;
}

void EditorController::takeTooth() {
    const SessionTooth& tooth = *parts_.model.tooth();
    tooth_ = tooth.piece->volume().tooth();
    outer_ = tooth_->ownOuter();
    if (adopted_) {
        loaded_ = adopted_->exercise();
        tool_.setDraft(nullptr);
        draft_ = std::exchange(adopted_, {});
        return showDraft();
    }
    if (trial_ != nullptr && exerciseOf(tooth) == trial_) return;
    if (!isOfDraft(tooth)) return end();
    if (const auto begun = std::exchange(pending_, nullptr)) {
        tool_.setDraft(nullptr);
        draft_.emplace(isCopy_ ? editableCopy(*begun, outer_) : *begun);
        loaded_ = draft_->exercise();
        showDraft();
        return lookAtCavity();
    }
    if (draft_) showDraft();
}

/// The panel, the lines, and the mouse for drawing.
void EditorController::showDraft() {
    if (panel_ == nullptr) makePanel();
    endTrial();
    tool_.setDraft(&*draft_);
    takeMouse();
    followDraft();
    parts_.messages.setHint(tr("The mouse draws the exercise on the tooth; right: turn, Ctrl and wheel: nearer"));
}

void EditorController::takeMouse() {
    const bool draws = isEditing() && trial_ == nullptr && !parts_.mode.isOn();
    parts_.panels.view->setSurfaceTool(draws ? &tool_ : nullptr);
    if (dock_ != nullptr) showPanel(isEditing() && !parts_.mode.isOn());
    if (draws) return;
    parts_.panels.view->outlines().setMarks(OutlineOverlay::Layer::Editor, {});
    ideal_.clear();
    showIdeal();
}

/// A panel that is not needed leaves the window, and takes none of its width.
void EditorController::showPanel(bool shows) {
    const bool isThere = parts_.window.dockWidgetArea(dock_) != Qt::NoDockWidgetArea;
    if (shows && !isThere) parts_.window.addDockWidget(Qt::LeftDockWidgetArea, dock_);
    if (!shows && isThere) parts_.window.removeDockWidget(dock_);
    dock_->setVisible(shows);
    const int bar = dock_->style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    if (shows && !isThere)
        parts_.window.resizeDocks({dock_}, {panel_->minimumSizeHint().width() + 2 * bar}, Qt::Horizontal);
}

void EditorController::makePanel() {
    panel_ = new EditorPanel;
    auto* area = new QScrollArea;
    area->setObjectName("editorArea");
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(panel_);
    dock_ = new QDockWidget(tr("Exercise editor"), &parts_.window);
    dock_->setObjectName("Exercise editor");
    dock_->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
    dock_->setWidget(area);
    dock_->hide();
    constexpr int kLeast = 220;  // pixels: with the largest text the window still fits on a small screen
    area->setMinimumWidth(kLeast);
    connectPanel();
    emit panelMade();
}

void EditorController::connectPanel() {
    ToothFields& tooth = panel_->tooth();
    connect(&panel_->ideal(), &IdealBox::chosen, this, &EditorController::showIdeal);
    connect(panel_, &EditorPanel::edited, this, &EditorController::edit);
    connect(panel_, &EditorPanel::trialWanted, this, &EditorController::tryIt);
    connect(panel_, &EditorPanel::returnWanted, this, &EditorController::comeBack);
    connect(panel_, &EditorPanel::savingWanted, this, [this] { askForFile({}); });
    connect(panel_, &EditorPanel::closingWanted, this, [this] {
        if (!draft_->isModified()) return end();
        askToClose([this] { end(); }, {});
    });
    connect(panel_, &EditorPanel::undoWanted, this, [this] {
        draft_->undo();
        followDraft();
    });
    connect(panel_, &EditorPanel::redoWanted, this, [this] {
        draft_->redo();
        followDraft();
    });
    connect(&tooth, &ToothFields::templateWanted, this, &EditorController::applyTemplate);
    connect(&tooth, &ToothFields::freeOutlineWanted, this, [this] {
        draft_->clearOutline();
        tool_.setStroke(DraftStroke::Outline);
        followDraft();
    });
    connect(&tooth, &ToothFields::strokeChosen, this, [this](DraftStroke stroke) {
        tool_.setStroke(stroke);
        followDraft();
    });
    connect(&tooth, &ToothFields::newZoneWanted, this, [this] {
        tool_.setStroke(DraftStroke::Zone);
        tool_.setZone(draft_->beginZone().zone);
        followDraft();
    });
    connect(&tooth, &ToothFields::zoneRemovalWanted, this, [this] {
        if (const auto zone = tool_.zone()) draft_->removeZone(*zone);
        followDraft();
    });
}

QString EditorController::problem() const {
    const bool isThere = loaded_ && haveSameTooth(*loaded_, draft_->exercise());
    auto found = draft_->problem(isThere ? outer_ : nullptr);
    if (!found) found = ideal_.fault();
    return found ? translated(*found) : QString();
}

/// Shows the draft as it is now; where it has another tooth, that is loaded.
void EditorController::followDraft() {
    if (!draft_ || trial_ != nullptr) return;
    if (!tool_.isInStroke() && !haveSameTooth(*loaded_, draft_->exercise())) {
        load(draft_->exercise());
        if (!parts_.teeth.isBusy()) return;  // it was declined
    }
    followIdeal();
    panel_->show(*draft_, problem());
    panel_->tooth().showStroke(tool_.stroke(), tool_.zone().has_value());
    if (parts_.mode.isOn()) return;
    OutlineMarks marks = marksOf(*draft_, outer_, tool_.held());
    if (draft_->openLine() && draft_->points(*draft_->openLine()).size() > 2) {
        marks.hint = tr("Click the next point, or the first one to close the line.");
    } else if (tool_.stroke() == DraftStroke::Decay) {
        marks.hint = tr("Click or drag: paint decay. Right click: take it away.");
    } else {
        marks.hint = tr("Click: add a point. Drag: move it. Right click: remove it.");
    }
    parts_.panels.view->outlines().setMarks(OutlineOverlay::Layer::Editor, std::move(marks));
    parts_.panels.view->outlines().follow(parts_.panels.view->viewport(), {});
}

/// Begins to make the ideal anew where it has changed: at the end of a stroke, on the tooth of the draft.
void EditorController::followIdeal() {
    const Exercise& exercise = draft_->exercise();
    if (!ideal_.isOf(exercise, tooth_)) ideal_.clear();
    const bool isThere = tooth_ != nullptr && haveSameTooth(*loaded_, exercise) && !parts_.mode.isOn();
    if (!isThere || (!tool_.isInStroke() && draft_->problemOfIdeal(outer_))) {
        ideal_.clear();
    } else if (!tool_.isInStroke()) {
        ideal_.follow(exercise, tooth_);
    }
    showIdeal();
}

void EditorController::poll() {
    const bool isPreparing = ideal_.isPreparing();
    if (ideal_.poll()) panel_->showProblem(problem());
    if (isPreparing) showIdeal();
}

/// What is out of date is not shown.
void EditorController::showIdeal() {
    std::shared_ptr<CavityGhost> shown;
    if (draft_ && panel_ != nullptr) {
        panel_->ideal().show(ideal_, draft_->exercise().opensPulp());
        if (ideal_.cavity() && panel_->ideal().isChosen()) shown = ideal_.cavity()->ghost;
    }
    if (shown != std::exchange(shownIdeal_, shown)) emit idealChanged();
}

void EditorController::edit(const QString& step, const ExerciseChange& change) {
    draft_->change(step.toStdString(), [&](Exercise& exercise) { changeWithWords(exercise, change); });
    followDraft();
}

void EditorController::applyTemplate(ExerciseTemplate kind) {
    if (parts_.teeth.isBusy()) return;  // the tooth is on its way
    edit({}, [&](Exercise& exercise) { tactooth::applyTemplate(kind, exercise, outer_); });
    draft_->closeLine();
    tool_.setStroke(DraftStroke::Outline);
    followDraft();
    lookAtCavity();
}

/// Turns the picture so that nothing hides the outline.
void EditorController::lookAtCavity() {
    const PreparationPlan* plan = draft_->plan();
    if (plan == nullptr || !plan->outline || plan->outline->corners.size() < 3) return;
    const ViewDirection view = viewOnto(*plan, parts_.model.tooth()->piece->tooth(), parts_.model.mesialX());
    parts_.panels.view->setView(OrbitCamera::Direction{view.azimuth, view.elevation});
    parts_.panels.view->fit();
}

void EditorController::tryIt() {
    if (!problem().isEmpty() || parts_.teeth.isBusy()) return;
    auto trial = std::make_shared<Exercise>(draft_->exercise());
    trial->file.clear();  // the list keeps what was saved
    trial_ = std::move(trial);
    takeMouse();
    panel_->setTrying(true);
    loadsOwn_ = true;
    parts_.exercise.start(trial_);
    loadsOwn_ = false;
}

void EditorController::comeBack() { load(draft_->exercise()); }

/// The fields again in place of the way back.
void EditorController::endTrial() {
    panel_->setTrying(false);
    const auto tried = std::exchange(trial_, nullptr);
    if (tried == nullptr) return;
    if (parts_.exercise.active() == tried) parts_.exercise.start(nullptr);
    parts_.exercise.remove(tried);
}

void EditorController::askForFile(const Function& saved) {
    if (const QString why = problem(); !why.isEmpty()) return parts_.messages.showError(why);
    std::filesystem::path file = draft_->exercise().file;
    if (file.empty()) {
        const std::filesystem::path folder = ownExerciseFolder();
        std::error_code ignored;  // the dialog then begins elsewhere
        if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
        file = folder / fileNameOf(draft_->exercise().name);
    }
    parts_.files.save(tr("Save exercise"), tr("Exercises (*.toml)"), QString::fromStdString(file.string()),
                      [this, saved](const QString& chosen) {
                          if (save(chosen) && saved) saved();
                      });
}

bool EditorController::save(const QString& file) {
    if (!draft_) return false;
    const std::filesystem::path path = file.toStdString();
    const Expected<void> written = writeExercise(draft_->exercise(), path);
    if (!written) {
        parts_.messages.showError(written.error());
        return false;
    }
    draft_->markSaved(path);
    loaded_ = draft_->exercise();
    parts_.exercise.add(std::make_shared<const Exercise>(draft_->exercise()));
    parts_.messages.setHint(tr("The exercise was saved to %1").arg(file));
    followDraft();
    return true;
}

void EditorController::askToClose(Function then, const Function& otherwise) {
    const auto cancel = [otherwise] {
        if (otherwise) otherwise();
    };
    if (question_ != nullptr) {
        question_->raise();
        return cancel();
    }
    question_ = new QMessageBox(QMessageBox::Warning, tr("Unsaved exercise"),
                                tr("The exercise has changes that are not saved. Save it first?"),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &parts_.window);
    question_->setObjectName("unsavedExercise");
    question_->setAttribute(Qt::WA_DeleteOnClose);
    question_->setDefaultButton(QMessageBox::Save);
    question_->setEscapeButton(QMessageBox::Cancel);
    connect(question_, &QDialog::finished, this, [this, then = std::move(then), cancel](int answer) {
        question_.clear();  // so that the answer may lead to another question
        if (answer == QMessageBox::Save) return askForFile(then);
        if (answer != QMessageBox::Discard) return cancel();
        end();
        then();
    });
    question_->open();
}

void EditorController::end() {
    if (!draft_) return;
    endTrial();
    tool_.setDraft(nullptr);
    draft_.reset();
    loaded_.reset();
    takeMouse();
}

std::optional<ExerciseDraft> EditorController::release() {
    tool_.setDraft(nullptr);
    ideal_.clear();
    return std::exchange(draft_, {});
}

void EditorController::adopt(ExerciseDraft draft) { adopted_ = std::move(draft); }

}  // namespace tactooth
