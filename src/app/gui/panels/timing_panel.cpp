// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/timing_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/panels/elided_label.h"
#include "haptics/real_time.h"
#include "session/model/session_model.h"

namespace tactooth {
namespace {

constexpr std::array<double, 4> kQuantiles = {0.5, 0.99, 0.999, 1.0};
const QColor kWorkColour(0, 114, 178),
    kLateColour(213, 94, 0);  // colour-blind people can distinguish them (Okabe and Ito)

}  // namespace

TimingPanel::TimingPanel(QWidget* parent) : QWidget(parent), picture_(new HistogramView), summary_(new ElidedLabel) {
    picture_->setAccessibleName(tr("Histogram of the servo's ticks"));
    picture_->setToolTip(
        tr("Histograms of the computing time and of the wake-up latency of the ticks. A time at the dashed line or "
           "beyond it means a missed tick."));
    auto* numbers = new QGridLayout;
    numbers->setHorizontalSpacing(12);
    numbers->setVerticalSpacing(1);
    const std::array<QString, kRows> names = {tr("tick duration, µs"), tr("wake-up latency, µs"),
                                              tr("period jitter, µs"), tr("reading to force, µs"),
                                              tr("picture in motion, ms")};
    const std::array<const char*, kColumns> heads = {"p50", "p99", "p99.9", QT_TR_NOOP("max")};
    for (std::size_t column = 0; column < kColumns; ++column) {
        numbers->addWidget(new QLabel(tr(heads[column])), 0, static_cast<int>(column) + 1, Qt::AlignRight);
    }
    for (std::size_t row = 0; row < kRows; ++row) {
        numbers->addWidget(new QLabel(names[row]), static_cast<int>(row) + 1, 0);
        for (std::size_t column = 0; column < kColumns; ++column) {
            cells_[row][column] = new QLabel;
            cells_[row][column]->setAccessibleName(names[row] + " " + tr(heads[column]));
            numbers->addWidget(cells_[row][column], static_cast<int>(row) + 1, static_cast<int>(column) + 1,
                               Qt::AlignRight);
        }
    }
    numbers->setRowStretch(static_cast<int>(kRows) + 1, 1);
    auto* anew = new QToolButton;
    anew->setText(tr("Count anew"));
    anew->setToolTip(tr("Clears all ticks so far, for example those of the program's start"));
    anew->setObjectName("countAnew");
    connect(anew, &QToolButton::clicked, this, [this] { from_ = latest_; });
    summary_->setObjectName("timingFacts");
    summary_->setAccessibleName(tr("Ticks"));
    auto* head = new QHBoxLayout;
    head->addWidget(summary_, 1);
    head->addWidget(anew);
    auto* body = new QHBoxLayout;
    body->setSpacing(16);
    body->addWidget(picture_, 1);
    body->addLayout(numbers);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 1, 4, 1);
    column->setSpacing(2);
    column->addLayout(head);
    column->addLayout(body, 1);
}

TimingPanel::Snapshot TimingPanel::now(const LiveRunner& runner, const LatencyCounts& pictures) {
    const ServoTiming& timing = runner.feed().timing();
    return {{timing.tick.counts(), timing.lateness.counts(), timing.jitter.counts(),
             runner.feed().deviceToForce().counts(), pictures},
            timing.ticks.load(std::memory_order_relaxed),
            timing.missed.load(std::memory_order_relaxed)};
}

void TimingPanel::Snapshot::forgetRunner() {
    const LatencyCounts pictures = rows[kPictures];
    *this = {};
    rows[kPictures] = pictures;
}

/// Otherwise the counters of another runner would count for this one until the next show.
void TimingPanel::reset() {
    latest_.forgetRunner();
    from_.forgetRunner();
    summary_->setText({});
    for (auto& row : cells_) {
        for (QLabel* cell : row) cell->clear();
    }
}

void TimingPanel::show(const LiveRunner& runner, const LatencyCounts& pictures, const QString& device, double rateHz) {
    latest_ = now(runner, pictures);
    std::array<LatencyCounts, kRows> counts;
    for (std::size_t row = 0; row < kRows; ++row) {
        counts[row] = latest_.rows[row].since(from_.rows[row]);
        for (std::size_t column = 0; column < kColumns; ++column) {
            const double unit = row == kPictures ? 1000 : 1;  // us
            cells_[row][column]->setText(locale().toString(counts[row].quantile(kQuantiles[column]) / unit, 'f', 0));
        }
    }
    const std::uint64_t ticks = latest_.ticks - from_.ticks;
    const std::uint64_t missed = latest_.missed - from_.missed;
    const double share =
        100 * static_cast<double>(missed) / static_cast<double>(std::max<std::uint64_t>(1, ticks + missed));
    const QStringList facts = {
        tr("%1 ticks, %2 missed (%3 %)").arg(locale().toString(ticks), locale().toString(missed)).arg(share, 0, 'f', 2),
        tr("Device: %1").arg(device),
        runner.feed().isRealTime() ? tr("Real-time priority") : tr("Ordinary priority (see 'tactooth doctor')"),
        isMemoryLocked() ? tr("Memory locked") : tr("Memory may be swapped out (see 'tactooth doctor')"),
        runner.feed().limitsCpuLatency() ? tr("Processors kept from deep sleep")
                                         : tr("Processors may sleep deeply (see 'tactooth doctor')")};
    summary_->setText(facts.join("  ·  "));
    picture_->show({{tr("tick duration"), kWorkColour, counts[0]}, {tr("wake-up latency"), kLateColour, counts[1]}},
                   1e6 / rateHz);
}

}  // namespace tactooth
