// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMessageBox>
#include <QObject>
#include <QPointer>
#include <optional>
#include <vector>

#include "session/model/session_restore.h"
#include "session/model/task.h"

namespace tactooth {

class RecordingController;
class SessionModel;
class ToothController;
class WindowMessages;

/// Offers at the start what an earlier session has left behind, and brings it back.
class RestoreController final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the controller; `window` is the parent of its questions.
    RestoreController(SessionModel& model, ToothController& teeth, RecordingController& recordings,
                      WindowMessages& messages, QWidget& window);
    /// Gives up a restoration that runs: its file stays.
    ~RestoreController() override;

    /// Looks for unfinished sessions in the background and asks about them. Nothing waits for the answer.
    void offer();
    /// Whether it looks for them, or brings one back.
    [[nodiscard]] bool isBusy() const { return search_.isBusy() || restoring_ != nullptr; }
    /// Call it before each step of the model.
    void poll();
    /// The tooth has come.
    void takeTooth();

private:
    struct Found {
        Leftover leftover;
        LeftoverFacts facts;
    };
    /// One restoration; its task shares it.
    struct Restoring {
        Leftover leftover;
        QString title;
        std::shared_ptr<RestoreProgress> progress;  // the status line may hold it longer than the file is held
        std::atomic<bool> isDone{false};
    };

    void askForNext();
    void answer(const Found& found, QMessageBox::ButtonRole role);
    void restore(const Found& found);
    void giveUp();

    SessionModel& model_;
    ToothController& teeth_;
    RecordingController& recordings_;
    WindowMessages& messages_;
    QWidget& window_;
    Task<std::vector<Found>> search_;
    std::vector<Found> found_;  // not asked about yet, newest first
    QPointer<QMessageBox> question_;
    std::shared_ptr<Restoring> restoring_;
};

}  // namespace tactooth
