// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>
#include <optional>

#include "app/gui/model/long_work.h"
#include "app/gui/panels/elided_label.h"
#include "session/live/live_runner.h"
#include "sound/output/sound_output.h"

namespace tactooth {

/// The status line: hint, removed volume, and whether the force comes in time.
class StatusLine final : public QStatusBar {
    Q_OBJECT

public:
    explicit StatusLine(QWidget* parent = nullptr);

    /// Call it about once a second: it shows the rates since the last call.
    void show(const LiveRunner& runner, SoundStatus sound);
    /// Shows a hint on the left side until the next hint.
    void setHint(const QString& hint) { hint_->setText(hint); }
    /// Shows work in the background, or that there is none. What takes longer than a moment has a bar and a button that
    /// cancels it. Returns whether the bar is visible.
    bool showWork(std::optional<LongWork> work);
    /// Whether it says how much was removed.
    void setShowsRemoved(bool shows) { removed_->setVisible(shows); }

private:
    void cancelWork();
    void showPace(double percentLate, const QString& details);

    ElidedLabel* hint_;
    QProgressBar* progress_;
    QToolButton* cancel_;
    std::optional<LongWork> work_;
    QElapsedTimer workingSince_;
    QLabel* removed_;
    QLabel* pace_;  // whether the machine keeps the rate of the force
    QLabel* sound_;
    QElapsedTimer since_;
    std::uint64_t ticks_ = 0;
    std::uint64_t missed_ = 0;
    std::uint64_t updates_ = 0;
};

}  // namespace tactooth
