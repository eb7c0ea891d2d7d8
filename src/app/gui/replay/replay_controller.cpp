// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_controller.h"

#include <QMainWindow>
#include <QStackedWidget>
#include <algorithm>
#include <array>
#include <utility>

#include "app/gui/controllers/file_dialogs.h"
#include "app/gui/controllers/panel_updater.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/model/examination_mode.h"
#include "app/gui/panels/device_panel.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "app/gui/panels/exercise_panel.h"
#include "app/gui/panels/force_panel.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/panels/plot_panel.h"
#include "app/gui/replay/replay_bar.h"
#include "app/gui/replay/replay_comment_menu.h"
#include "app/gui/replay/replay_panel.h"
#include "app/gui/replay/replay_trace.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/translation.h"
#include "geometry/files/file_bytes.h"

namespace tactooth {
namespace {

constexpr int kStepMs = 16;           // 60 steps a second
constexpr int kNumbersMs = 100;       // ten times a second
constexpr double kLongestStep = 0.1;  // s: after a stall the replay goes on where it was
constexpr double kSameTime = 1e-6;    // s: less than a tick

PlotPanel::Recorded recordedUpTo(const SessionTrack& track, double time) {
    return {traceBefore(track, track.momentAt(time)), std::max(0.0, time - track.seconds())};
}

}  // namespace

ReplayController::ReplayController(QMainWindow& window, SessionModel& model, const ExaminationMode& mode,
                                   const WindowPanels& panels, WindowMessages& messages, FileDialogs& files,
                                   PanelUpdater& updater, SoundOutput& sound)
    : window_(window),
      model_(model),
      mode_(mode),
      panels_(panels),
      messages_(messages),
      files_(files),
      updater_(updater),
      sound_(sound),
      comparison_(messages, files) {
    connect(&timer_, &QTimer::timeout, this, &ReplayController::step);
    connect(&numbers_, &QTimer::timeout, this, &ReplayController::showNumbers);
    connect(panels_.inspection, &InspectionPanel::changed, this, &ReplayController::showInspection);
    connect(&comparison_, &ReplayComparison::changed, this, &ReplayController::showComparison);
    connect(&mode_, &ExaminationMode::changed, this, [this] {
        opening_.cancel();
        if (!mode_.allowsReplay() && isActive()) leave();
    });
}

ReplayController::~ReplayController() {
    if (panel_ == nullptr) return;
    panel_->removeOther();
    panel_->view().setContents({});  // they are this object's
}

void ReplayController::askForRecording() {
    files_.open(tr("Open recording"), tr("Recorded sessions (*.ttsession);;All files (*)"),
                [this](const QString& file) { open(file); });
}

void ReplayController::openAt(const QString& file, double time) {
    if (!mode_.allowsReplay()) return messages_.setHint(tr("Recordings can be opened when the examination is over"));
    openedAt_ = time;
    openingOther_.clear();
    files_.enterFolderOf(file);
    messages_.setHint(tr("Opening recording %1…").arg(file));
    opening_.start([path = std::filesystem::path(file.toStdString())] { return ReplaySource::open(path); });
    timer_.start(kStepMs);
}

void ReplayController::openTwo(const QString& file, const QString& other) {
    open(file);
    openingOther_ = other;
}

void ReplayController::pollOpening() {
    if (auto opened = opening_.poll()) {
        if (*opened) {
            enter(std::move(**opened));
            const QString other = std::exchange(openingOther_, {});
            if (!other.isEmpty()) comparison_.open(other, comparison_.usualMode());
        } else {
            messages_.setHint({});
            messages_.showError(opened->error());
            if (!isActive()) emit left();
        }
    }
    comparison_.poll();
    if (!isActive() && !isLoading()) timer_.stop();
}

void ReplayController::makePanel() {
    panel_ = new ReplayPanel(sound_);
    static_cast<QStackedWidget*>(window_.centralWidget())->addWidget(panel_);
    comments_ = std::make_unique<ReplayCommentMenu>(panel_->bar().commentMenu(), messages_, window_);
    panel_->view().setContents([this](bool withTurbine, bool) { return contents(withTurbine); });
    panel_->bar().addSideBySide(comparison_.sideBySideAction());
    connect(&panel_->first(), &ReplayPicture::closeWanted, this, &ReplayController::closeFirst);
    connectBar();
    emit pictureMade();
}

void ReplayController::connectBar() {
    const ReplayBar& bar = panel_->bar();
    connect(&bar, &ReplayBar::playToggled, this, [this] { cursor_->setPlaying(!cursor_->isPlaying()); });
    connect(&bar, &ReplayBar::timeChosen, this, [this](double time) { cursor_->jumpTo(time); });
    connect(&bar, &ReplayBar::speedChosen, this, [this](double speed) { cursor_->setSpeed(speed); });
    connect(&bar, &ReplayBar::stepped, this, [this](int ticks) { cursor_->step(ticks); });
    connect(&bar, &ReplayBar::nextWanted, this, [this] { cursor_->jumpToNext(markTimes()); });
    connect(&bar, &ReplayBar::previousWanted, this, [this] { cursor_->jumpToPrevious(markTimes()); });
    connect(&bar, &ReplayBar::compareToggled, &comparison_, &ReplayComparison::toggle);
    connect(&bar, &ReplayBar::shiftChosen, &comparison_, &ReplayComparison::setShift);
    connect(&bar, &ReplayBar::alignWanted, &comparison_, &ReplayComparison::align);
    connect(&bar, &ReplayBar::leaveWanted, this, &ReplayController::leave);
    connect(&bar, &ReplayBar::commentWanted, this, [this] {
        cursor_->setPlaying(false);
        comments_->askFor(cursor_->time());
    });
    connect(comments_.get(), &ReplayCommentMenu::changed, this, &ReplayController::showMarks);
    connect(comments_.get(), &ReplayCommentMenu::timeChosen, this, [this](double time) { cursor_->jumpTo(time); });
}

void ReplayController::enter(Opened source) {
    if (panel_ == nullptr) makePanel();
    if (!isActive()) {
        panels_.tour->stop();
        bench_ = model_.tooth() ? model_.tooth()->piece : nullptr;
        wasPaused_ = model_.isPaused();
        model_.setPaused(true);
        updater_.setReplaying(true);
        setLocked(true);
    }
    source_ = std::move(source);
    cursor_.emplace(source_->track());
    comparison_.setFirst(source_->track());
    cursor_->jumpTo(openedAt_);
    shownEvents_ = 0;
    reportedEnd_ = false;
    heardBur_.reset();
    panel_->setSource(*source_);
    comments_->open(source_->file());
    static_cast<QStackedWidget*>(window_.centralWidget())->setCurrentWidget(panel_);
    showInspection();
    panel_->view().setFocus();
    messages_.setHint(tr("Replay: Space plays and pauses, Escape leads back to the tooth."));
    sinceStep_.start();
    numbers_.start(kNumbersMs);
}

void ReplayController::leave() {
    if (!isActive()) return;
    numbers_.stop();
    comparison_.setFirst(nullptr);
    static_cast<QStackedWidget*>(window_.centralWidget())->setCurrentWidget(panels_.view);
    cursor_.reset();
    source_.reset();
    bench_.reset();
    setLocked(false);
    updater_.setReplaying(false);
    model_.setPaused(wasPaused_);
    messages_.setHint(tr("The tooth is as you left it."));
    emit left();
}

/// What would change the tooth on the bench, or the force.
void ReplayController::setLocked(bool locked) {
    const std::array<QWidget*, 4> panels = {panels_.drill, panels_.force, panels_.device, panels_.exercise};
    for (QWidget* panel : panels) panel->setEnabled(!locked);
    for (QAction* action : {panels_.drill->touchAction(), panels_.drill->cutAction(), panels_.drill->undoAction(),
                            panels_.drill->resetAction()}) {
        action->setEnabled(!locked);
    }
}

/// The user has opened one meanwhile, and wants to see it.
bool ReplayController::isOtherToothOnTheBench() {
    const std::shared_ptr<CutModel> now = model_.tooth() ? model_.tooth()->piece : nullptr;
    return std::exchange(bench_, now) != now && now != nullptr;
}

void ReplayController::step() {
    const bool hadNoTooth = bench_ == nullptr;  // the first one comes in the background
    pollOpening();
    if (!isActive()) return;
    if (isOtherToothOnTheBench() && !hadNoTooth) return leave();
    cursor_->advance(std::min(static_cast<double>(sinceStep_.restart()) / 1000, kLongestStep));
    panel_->coupleCameras();
    panel_->view().refresh();
    panel_->first().showTime(cursor_->time(), lengthOf(*source_->track()));
    if (ReplayPicture* other = panel_->other()) {
        other->view().refresh();
        other->showTime(cursor_->otherTime(), lengthOf(*comparison_.source()->track()));
    }
    panel_->bar().show(*cursor_);
    comments_->setTime(cursor_->time());
    playSound();
}

SceneContents ReplayController::contents(bool withTurbine) {
    if (!isActive()) return {};
    SceneContents contents = contentsOf(*source_, cursor_->moment(), withTurbine);
    if (!comparison_.isGhost()) return contents;
    SceneContents other = contentsOf(*comparison_.source(), cursor_->otherMoment(), withTurbine);
    contents.other = ShownOther{std::move(other.tooth), std::move(other.tool)};
    return contents;
}

/// Of the picture beside the first.
SceneContents ReplayController::otherContents(bool withTurbine) {
    if (!isActive() || !comparison_.isSideBySide()) return {};
    return contentsOf(*comparison_.source(), cursor_->otherMoment(), withTurbine);
}

/// The switch of the mirror in the menu counts here, too: it may hide what somebody wants to see.
SceneContents ReplayController::contentsOf(ReplaySource& source, std::uint64_t moment, bool withTurbine) {
    SceneContents contents = source.contentsAt(moment, withTurbine ? panel_->first().handpieces() : HandpieceMeshes());
    if (!panels_.view->showsMirror()) contents.mirror.reset();
    return contents;
}

void ReplayController::showComparison() {
    if (!isActive()) return;
    const Opened& other = comparison_.source();
    if (other != nullptr) {
        cursor_->setOther(other->track(), comparison_.shift());
    } else {
        cursor_->removeOther();
    }
    panel_->bar().showOther(
        other != nullptr ? QString::fromStdString(displayName(other->file().filename())) : QString(),
        comparison_.shift());
    const Opened before = std::exchange(besides_, comparison_.isSideBySide() ? other : nullptr);
    if (besides_ == before) return;
    if (besides_ == nullptr) return panel_->removeOther();
    panel_->addOther(*besides_);
    panel_->other()->view().setContents([this](bool withTurbine, bool) { return otherContents(withTurbine); });
    connect(panel_->other(), &ReplayPicture::closeWanted, &comparison_, &ReplayComparison::close);
    showInspection();
    emit pictureMade();
}

/// The other recording becomes the only one, at its own time and seen from where it was.
void ReplayController::closeFirst() {
    if (!comparison_.isSideBySide()) return;
    const OrbitCamera camera = panel_->view().orbitCamera();
    const bool isPlaying = cursor_->isPlaying();
    const double speed = cursor_->speed();
    openedAt_ = cursor_->otherTime();
    enter(comparison_.release());
    cursor_->setPlaying(isPlaying);
    cursor_->setSpeed(speed);
    panel_->view().setOrbitCamera(camera);
}

void ReplayController::showMarks() {
    std::vector<ReplaySlider::Mark> marks;
    for (const TrackEvent& event : source_->track()->events()) {
        marks.push_back({event.time, translated(Message(*event.text)), false});
    }
    for (const ReplayComment& comment : comments_->all()) {
        marks.push_back({comment.time, QString::fromStdString(comment.text), true});
    }
    std::ranges::stable_sort(marks, {}, &ReplaySlider::Mark::time);
    panel_->bar().setMarks(std::move(marks));
}

std::vector<double> ReplayController::markTimes() const {
    std::vector<double> times;
    for (const ReplaySlider::Mark& mark : panel_->bar().marks()) times.push_back(mark.time);
    return times;
}

/// The last mark before the cursor; of several at the same time a comment.
void ReplayController::showNote() {
    const std::vector<ReplaySlider::Mark>& marks = panel_->bar().marks();
    const auto later = std::ranges::upper_bound(marks, cursor_->time() + kSameTime, {}, &ReplaySlider::Mark::time);
    if (later == marks.begin()) return panel_->bar().showNote({});
    const ReplaySlider::Mark& last = *std::prev(later);
    panel_->bar().showNote(QString("%1 s: %2").arg(window_.locale().toString(last.time, 'f', 1), last.text));
}

void ReplayController::showNumbers() {
    if (!isActive()) return;
    const SessionTrack& track = *source_->track();
    if (const std::size_t events = track.events().size(); events != std::exchange(shownEvents_, events)) showMarks();
    showNote();
    const std::uint64_t moment = cursor_->moment();
    if (const Opened& other = comparison_.source()) {
        panels_.plots->show(recordedUpTo(track, cursor_->time()), recordedUpTo(*other->track(), cursor_->otherTime()));
    } else {
        panels_.plots->show(traceBefore(track, moment));
    }
    panels_.drive->show(track.tickBefore(moment).tick());
    if (track.isFinished() && !std::exchange(reportedEnd_, true)) reportEnd();
}

void ReplayController::showInspection() {
    if (!isActive()) return;
    inspect(*source_, panel_->view());
    if (besides_ != nullptr) inspect(*besides_, panel_->other()->view());
}

void ReplayController::inspect(const ReplaySource& source, ToothView& view) {
    const LayeredTooth& tooth = source.uncut()->tooth();
    Inspection inspection = panels_.inspection->inspection(tooth.outer()->tree().box(), 1, tooth.materials());
    inspection.distances.reset();  // they belong to the tooth on the bench
    inspection.ghost.reset();
    view.setInspection(inspection, panels_.inspection->stereo());
}

void ReplayController::reportEnd() {
    const SessionTrack& track = *source_->track();
    if (const std::optional<Message> fault = track.fault()) messages_.showError(translated(*fault));
    if (const std::optional<double> differsAt = track.differsAt()) {
        messages_.setHint(tr("This program differs from the one that made the recording: from %1 s on the replay is "
                             "not what happened.")
                              .arg(window_.locale().toString(*differsAt, 'f', 1)));
    }
}

/// At its own speed only: otherwise no drill sounds like that.
void ReplayController::playSound() {
    const std::uint64_t moment = cursor_->moment();
    if (!cursor_->isPlaying() || cursor_->speed() != ReplayCursor::kOwnSpeed || moment == 0) return;
    const std::shared_ptr<const TrackBur> bur = source_->track()->burAt(moment);
    if (bur == nullptr) return;
    if (bur != heardBur_) {
        tickSound_.emplace(bur->begin.settings.spindle, bur->begin.settings.materials, bur->begin.instrument.edge);
        heardBur_ = bur;
    }
    DrillSoundState heard = tickSound_->at(source_->track()->tickBefore(moment).tick());
    model_.instruments().muteIdle(heard);
    sound_.publish(heard);
}

}  // namespace tactooth
