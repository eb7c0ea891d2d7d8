// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/gui/controllers/window_panels.h"
#include "assessment/exercise.h"
#include "session/model/session_model.h"

namespace tactooth {

/// Puts into the hand what the user takes from the instrument tray, and shows there what is in the hand.
class InstrumentController final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the controller.
    InstrumentController(SessionModel& model, const WindowPanels& panels);

    /// Offers what this exercise allows; null: all. What is in the hand and not allowed is changed.
    void follow(std::shared_ptr<const Exercise> exercise);
    /// Another runner has started: maybe with another instrument, or another drive.
    void takeRunner();
    /// Gives the tray the surfaces of the handpieces as soon as they are made. Call it in every step.
    void poll();

signals:
    /// Another instrument is in the hand.
    void changed();

private:
    void takeHandpiece(const SpindlePreset& drive);
    void takeHandInstrument(HandInstrument kind);
    void keepToExercise();

    SessionModel& model_;
    WindowPanels panels_;
    std::shared_ptr<const Exercise> exercise_;  // null: there is none
    std::optional<SessionBur> bur_;             // the last one in a handpiece
    std::optional<HandInstrument> shown_;
    bool hasHandpieces_ = false;  // the tray
};

}  // namespace tactooth
