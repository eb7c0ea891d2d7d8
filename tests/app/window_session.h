// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMessageBox>
#include <QTest>
#include <functional>
#include <memory>

#include "app/gui/panels/dial_gauge.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/window/main_window.h"
#include "sound/output/openal_output.h"
#include "support/test_data.h"

namespace tactooth::test {

/// The real window with the built-in molar and a round bur, worked by mouse and key events.
class WindowSession : public QObject {
public:
    ~WindowSession() override;

protected:
    WindowSession();

    /// How long a test waits for a picture, a program or a thread before it fails, ms. A slow machine with software
    /// OpenGL needs seconds, and many of them beside other tests; only a broken program needs this long.
    static constexpr int kPatience = 120'000;
    /// The same for a tooth, a mouth or an import.
    static constexpr int kLoadPatience = 300'000;

    void openWindow();
    /// The same, and applies its own settings as those of a file.
    void openWindowWithSettings();
    void closeWindow();
    void waitForTooth();
    /// Loads the built-in molar. Cuts that are not saved are discarded.
    void loadMolar();
    /// The question about unsaved cuts; null if there is none.
    [[nodiscard]] QMessageBox* unsavedQuestion() const { return window_->findChild<QMessageBox*>("unsavedWork"); }
    /// Answers it, if there is one.
    void answerUnsaved(QMessageBox::StandardButton answer) const;
    /// Cuts a little, and lifts the bur.
    void cutALittle();
    /// Where the picture shows the middle of the chewing surface or edge.
    [[nodiscard]] QPoint onCrown() const;
    [[nodiscard]] QPoint middle() const { return view().rect().center(); }
    [[nodiscard]] ToothView& view() const { return *window_->findChild<ToothView*>("toothView"); }
    [[nodiscard]] double gauge(const char* name) const { return window_->findChild<DialGauge*>(name)->value(); }
    [[nodiscard]] double removed() const { return total(window_->model().runner()->feed().removed()); }
    /// The part of it that burs have cut. A detached piece falls only after the bur has lifted, on a busy machine late.
    [[nodiscard]] double ground() const { return total(window_->model().runner()->feed().loss().ground()); }
    [[nodiscard]] const Surface& surface() const { return *window_->model().runner()->feed().surface(); }
    void key(Qt::Key which, Qt::KeyboardModifiers with = {}) const;
    void pressBurOn(const QPoint& place) const;
    /// Presses the pedal until `hasHappened`. A window that is not in front lets go of it, and then it is pressed
    /// again. False if that takes longer than kPatience.
    [[nodiscard]] bool waitWithPedal(const std::function<bool()>& hasHappened);
    /// What hand and tool do now.
    [[nodiscard]] QString stateOfHand() const;
    void liftBur(const QPoint& place) const;
    /// Until the window has made so many steps: an event of mouse, key or gamepad has taken effect.
    void waitForSteps(int steps) const;
    /// Until the carving thread has no work left. The bur must be clear of the tooth.
    void waitForCarving() const;
    /// Until all files are written that are saved and exported.
    void waitForFiles() const;
    /// Restarts the runner, which empties the plots, and waits until the window rests.
    void waitForRest() const;
    /// Waits until the view is at rest and has drawn no picture for a second: a slow machine may have one on its way.
    /// False if that takes longer than kPatience.
    [[nodiscard]] bool waitForQuietPicture() const;
    /// Closes the message in front and returns its text; empty if there is none.
    [[nodiscard]] QString dismissMessage() const;
    /// The same after all files are written.
    [[nodiscard]] QString messageAfterFiles() const;

    TemporaryFolder folder_;
    std::unique_ptr<OpenAlOutput> sound_;
    std::unique_ptr<MainWindow> window_;

private:
    class Focus;
    std::unique_ptr<Focus> focus_;
};

}  // namespace tactooth::test
