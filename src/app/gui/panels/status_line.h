// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>
#include <optional>

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
    /// Something is being loaded, `share` of it is done (0..1; none: nobody knows), or nothing is. What takes longer
    /// than a moment has a bar and a button that cancels it. `canCancel`: there is a tooth to go back to. Returns
    /// whether the bar is visible.
    bool showLoading(bool isLoading, const std::optional<double>& share, bool canCancel);
    /// The same while a work is assessed.
    bool showAssessing(double share);
    /// Whether it says how much was removed.
    void setShowsRemoved(bool shows) { removed_->setVisible(shows); }

signals:
    void loadingCancelled();

private:
    bool showBar(bool isBusy, const std::optional<double>& share, bool canCancel);
    void showPace(double percentLate, const QString& details);

    ElidedLabel* hint_;
    QProgressBar* progress_;
    QToolButton* cancel_;
    QElapsedTimer loadingSince_;
    QLabel* removed_;
    QLabel* pace_;  // whether the machine keeps the rate of the force
    QLabel* sound_;
    QElapsedTimer since_;
    std::uint64_t ticks_ = 0;
    std::uint64_t missed_ = 0;
    std::uint64_t updates_ = 0;
};

}  // namespace tactooth
