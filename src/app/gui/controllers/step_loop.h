// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "geometry/util/message.h"
#include "session/model/session_model.h"

namespace tactooth {

/// Steps the session some 60 times a second and notifies the other parts of the window of changes. It steps less
/// often while nothing moves, so that an idle window leaves the processor to others.
class StepLoop final : public QObject {
    Q_OBJECT

public:
    /// `model` outlives the loop. The first step comes when the event loop runs.
    explicit StepLoop(SessionModel& model);

    /// Steps at the full rate again: the user has moved something.
    void wake() { idleSteps_ = 0; }
    /// While something is loaded the loop does not rest.
    void setBusy(bool busy) { busy_ = busy; }
    /// Whether it steps less often because nothing moves.
    [[nodiscard]] bool isResting() const;

signals:
    /// `dt`: since the last step, s.
    void aboutToStep(double dt);
    void faultChanged(const Message* fault);  ///< of a device; null: none any more
    void overloaded(double microseconds);     ///< SessionModel::StepResult::heavyTick
    void recordingFailed(const Message& why);
    void recordingResumed();
    void runnerStarted();
    void toothChanged();
    void stepped();
    void numbersDue();
    void statusDue();

private:
    void step();
    void report(const SessionModel::StepResult& result);
    void adaptInterval();

    SessionModel& model_;
    QTimer stepTimer_, numbersTimer_, statusTimer_;
    QElapsedTimer sinceStep_;
    Vec3 lastPlace_ = Vec3::Zero();  // of the tool
    int idleSteps_ = 0;              // since something has moved
    bool busy_ = false;
};

}  // namespace tactooth
