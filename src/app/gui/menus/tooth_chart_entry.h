// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/gui/settings/window_settings.h"
#include "instruments/notation/tooth_notation.h"

class QAction;
class QWidget;

namespace tactooth {

class ExerciseController;
class SessionModel;
class ToothController;

/// The entry that opens the tooth chart. In a tool bar it shows the number of the tooth on the bench.
class ToothChartEntry final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive it; `window` is the parent of the chart.
    ToothChartEntry(QWidget& window, SessionModel& model, ToothController& teeth, ExerciseController& exercise);

    [[nodiscard]] QAction& action() const { return *action_; }
    /// Another tooth has come.
    void showTooth();
    void restore(const WindowSettings& settings);
    void store(WindowSettings& settings) const;

private:
    void open();

    QWidget& window_;
    SessionModel& model_;
    ToothController& teeth_;
    ExerciseController& exercise_;
    QAction* action_;
    ToothNotation notation_ = ToothNotation::Fdi;
};

}  // namespace tactooth
