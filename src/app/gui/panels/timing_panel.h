// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "app/gui/panels/histogram_view.h"
#include "session/live/live_runner.h"

class QLabel;

namespace tactooth {

class ElidedLabel;

/// Real-time behaviour: how long the ticks of the servo took, how late they began, how many were missed, what the
/// system allows, and how long the pictures took.
class TimingPanel final : public QWidget {
    Q_OBJECT

public:
    explicit TimingPanel(QWidget* parent = nullptr);

    /// `pictures`: how long those in motion took since the program's start. `device`: its name for people. Call it
    /// about once a second.
    void show(const LiveRunner& runner, const LatencyCounts& pictures, const QString& device, double rateHz);
    /// The next values belong to another runner, which counts from zero.
    void reset();

private:
    static constexpr std::size_t kRows = 5, kColumns = 4;
    static constexpr std::size_t kPictures = 4;  // the row of the pictures; the others are counters of the runner
    /// All counters at one moment.
    struct Snapshot {
        std::array<LatencyCounts, kRows> rows;
        std::uint64_t ticks = 0, missed = 0;
        /// The pictures go on.
        void forgetRunner();
    };
    [[nodiscard]] static Snapshot now(const LiveRunner& runner, const LatencyCounts& pictures);

    HistogramView* picture_;
    std::array<std::array<QLabel*, kColumns>, kRows> cells_{};
    ElidedLabel* summary_;
    Snapshot latest_;  // of the last show
    Snapshot from_;    // the counters of the panel begin here
};

}  // namespace tactooth
