// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "app/gui/controllers/window_panels.h"
#include "app/gui/replay/replay_comparison.h"
#include "app/gui/replay/replay_cursor.h"
#include "app/gui/replay/replay_source.h"
#include "session/audio/tick_sound.h"
#include "session/model/session_model.h"
#include "session/model/task.h"

class QMainWindow;

namespace tactooth {

class ExaminationMode;
class FileDialogs;
class PanelUpdater;
class ReplayCommentMenu;
class ReplayPanel;
class ToothView;
class WindowMessages;

/// Replays recordings in the window: opens them, plays them, and leads back to the tooth on the bench, which waits
/// unchanged. While a recording is shown the simulation stands still, so that no device pushes against a tooth that
/// nobody sees.
class ReplayController final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the controller. The middle of the window is a QStackedWidget.
    ReplayController(QMainWindow& window, SessionModel& model, const ExaminationMode& mode, const WindowPanels& panels,
                     WindowMessages& messages, FileDialogs& files, PanelUpdater& updater, SoundOutput& sound);
    ~ReplayController() override;

    void askForRecording();
    void open(const QString& file) { openAt(file, 0); }
    /// Shows the recording from this time on, s.
    void openAt(const QString& file, double time);
    /// Shows a recording and, as soon as it is there, another one to compare with.
    void openTwo(const QString& file, const QString& other);
    void leave();

    [[nodiscard]] bool isActive() const { return source_ != nullptr; }
    /// A recording is being opened.
    [[nodiscard]] bool isLoading() const { return opening_.isBusy() || comparison_.isOpening(); }
    /// While a recording is shown; else null.
    [[nodiscard]] ReplayPanel* panel() const { return isActive() ? panel_ : nullptr; }
    [[nodiscard]] ReplaySource* source() const { return source_.get(); }
    /// The other recording, which is compared with this one.
    [[nodiscard]] ReplayComparison& comparison() { return comparison_; }
    [[nodiscard]] const ReplayComparison& comparison() const { return comparison_; }
    /// While a recording is shown.
    [[nodiscard]] ReplayCursor& cursor() { return *cursor_; }

signals:
    /// A picture has been made, and does not know the keys yet.
    void pictureMade();
    /// No recording is shown any more, or it could not be opened.
    void left();

private:
    using Opened = std::shared_ptr<ReplaySource>;

    void makePanel();
    void connectBar();
    void step();
    void pollOpening();
    void enter(Opened source);
    void setLocked(bool locked);
    [[nodiscard]] bool isOtherToothOnTheBench();
    [[nodiscard]] SceneContents contents(bool withTurbine);
    [[nodiscard]] SceneContents otherContents(bool withTurbine);
    [[nodiscard]] SceneContents contentsOf(ReplaySource& source, std::uint64_t moment, bool withTurbine);
    void showComparison();
    void closeFirst();
    void showMarks();
    void showNote();
    void showNumbers();
    void showInspection();
    void inspect(const ReplaySource& source, ToothView& view);
    void reportEnd();
    void playSound();
    [[nodiscard]] std::vector<double> markTimes() const;

    QMainWindow& window_;
    SessionModel& model_;
    const ExaminationMode& mode_;
    WindowPanels panels_;
    WindowMessages& messages_;
    FileDialogs& files_;
    PanelUpdater& updater_;
    SoundOutput& sound_;
    Task<Opened> opening_;
    QString openingOther_;  // file of the other recording that is opened with it, or empty
    ReplayComparison comparison_;
    ReplayPanel* panel_ = nullptr;  // made when it is needed first; the window owns it
    std::unique_ptr<ReplayCommentMenu> comments_;
    Opened source_;
    Opened besides_;  // the other recording that has a picture of its own
    std::optional<ReplayCursor> cursor_;
    std::shared_ptr<CutModel> bench_;  // the tooth on the bench when the replay began
    bool wasPaused_ = false;           // the simulation, before the replay began
    double openedAt_ = 0;              // s: where the replay of the recording that is being opened begins
    std::size_t shownEvents_ = 0;
    bool reportedEnd_ = false;
    std::shared_ptr<const TrackBur> heardBur_;
    std::optional<TickSound> tickSound_;
    QTimer timer_, numbers_;
    QElapsedTimer sinceStep_;
};

}  // namespace tactooth
