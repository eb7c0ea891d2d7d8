// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/gui/controllers/window_panels.h"
#include "app/gui/panels/tick_trace.h"
#include "sound/output/sound_output.h"

class QWidget;

namespace tactooth {

/// Shows the session in the picture, the gauges, the plots and the status line.
class PanelUpdater final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the updater.
    PanelUpdater(SessionModel& model, const WindowPanels& panels, const SoundOutput& sound);

    /// After each step of the model. `busy`: work goes on in the background.
    void showStep(bool busy);
    /// While a recording is replayed, gauges and plots show that.
    void setReplaying(bool replaying) { replaying_ = replaying; }
    /// Another runner counts from zero.
    void restart();
    /// Gauges, plots and events; some ten times a second.
    void showNumbers();
    /// About once a second.
    void showStatus();

private:
    SessionModel& model_;
    WindowPanels panels_;
    const SoundOutput& sound_;
    TickTrace trace_;
    bool replaying_ = false;
};

/// Whether any part of a panel is visible. For Qt a panel behind another tab is visible too.
[[nodiscard]] bool isInSight(const QWidget& panel);

}  // namespace tactooth
