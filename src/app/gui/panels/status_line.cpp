// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/status_line.h"

#include <QLocale>
#include <functional>
#include <utility>

#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

QString removedText(const MaterialVolumes& removed, const MaterialRegistry& materials) {
    QStringList parts;
    for (const MaterialId id : materials.ids()) {
        constexpr double kShown = 0.005;  // mm^3: less would show as 0.00
        const double volume = removed[static_cast<std::size_t>(id)];
        if (volume >= kShown) parts += materialTitle(materials[id]) + ' ' + QLocale().toString(volume, 'f', 2);
    }
    if (parts.isEmpty()) return StatusLine::tr("Nothing removed yet");
    return StatusLine::tr("Removed: %1 mm³").arg(parts.join(", "));
}

constexpr double kNoticeableOverrun = 1;  // percent
constexpr int kBarWidth = 160;            // pixels
constexpr qint64 kMomentMs = 700;         // a bar that comes and goes would only flicker
constexpr int kPercent = 100;

}  // namespace

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent),
      hint_(new ElidedLabel),
      progress_(new QProgressBar),
      cancel_(new QToolButton),
      removed_(new QLabel),
      pace_(new QLabel),
      sound_(new QLabel) {
    hint_->setObjectName("hint");
    addWidget(hint_, 1);  // in a small window the numbers keep their space
    progress_->setObjectName("loadProgress");
    progress_->setMaximumWidth(kBarWidth);
    cancel_->setObjectName("cancelLoading");
    cancel_->setText(tr("Cancel"));
    cancel_->setAutoRaise(true);
    for (QWidget* part : std::initializer_list<QWidget*>{progress_, cancel_}) {
        part->setMaximumHeight(fontMetrics().height());  // else the panels would jump when they come and go
        addWidget(part);
        part->hide();
    }
    connect(cancel_, &QToolButton::clicked, this, &StatusLine::cancelWork);
    for (QWidget* part : std::initializer_list<QWidget*>{removed_, pace_, sound_}) addPermanentWidget(part);
    removed_->setObjectName("removed");
    pace_->setObjectName("pace");
    pace_->setTextFormat(Qt::RichText);
}

bool StatusLine::showWork(std::optional<LongWork> work) {
    const bool isOther = work.has_value() != work_.has_value() || (work && work->title != work_->title);
    work_ = std::move(work);
    if (!work_) {
        workingSince_.invalidate();
    } else if (isOther) {
        workingSince_.start();
    }
    const bool isLong = work_ && workingSince_.elapsed() > kMomentMs;
    progress_->setVisible(isLong);
    cancel_->setVisible(isLong && work_->cancel);
    if (!isLong) return false;
    progress_->setAccessibleName(work_->title);
    cancel_->setToolTip(work_->cancelTip);
    progress_->setRange(0, work_->share ? kPercent : 0);
    if (work_->share) progress_->setValue(static_cast<int>(*work_->share * kPercent));
    return true;
}

void StatusLine::cancelWork() {
    if (work_ && work_->cancel) std::function(work_->cancel)();  // a copy: another work may come in its place
}

/// A lamp with words, so that nobody has to distinguish its colours.
void StatusLine::showPace(double percentLate, const QString& details) {
    const bool isLate = percentLate > kNoticeableOverrun;
    const QString lamp = QString("<span style=\"color:%1\">●</span> ").arg(isLate ? "#d04030" : "#2f9e44");
    pace_->setText(lamp + (isLate ? tr("Force late") : tr("Force on time")).toHtmlEscaped());
    pace_->setMinimumWidth(pace_->sizeHint().width());  // the status bar would make space for a longer text too late
    pace_->setToolTip(
        tr("In the last second %1 % of the force came too late.").arg(QLocale().toString(percentLate, 'f', 1)) + '\n' +
        tr("More than 1 % is felt: close other programs, or take a tooth with fewer triangles.") + '\n' + details +
        '\n' + tr("The panel Real time shows more."));
}

void StatusLine::show(const LiveRunner& runner, SoundStatus sound) {
    const ServoTiming& timing = runner.feed().timing();
    const std::uint64_t ticks = timing.ticks.load(std::memory_order_relaxed);
    const std::uint64_t updates = runner.feed().surfaceUpdates();
    const double seconds = since_.isValid() ? static_cast<double>(since_.restart()) / 1000 : (since_.start(), 0.0);
    // Another runner counts from zero.
    const bool counts = seconds > 0 && ticks >= ticks_ && updates >= updates_;
    const double rate = counts ? static_cast<double>(ticks - ticks_) / seconds : 0;
    const double updateRate = counts ? static_cast<double>(updates - updates_) / seconds : 0;
    const std::uint64_t missed = timing.missed.load(std::memory_order_relaxed);
    const std::uint64_t late = counts && missed >= missed_ ? missed - missed_ : 0;
    const std::uint64_t all = counts ? ticks - ticks_ + late : 0;
    const double percentLate = all > 0 ? 100 * static_cast<double>(late) / static_cast<double>(all) : 0;
    ticks_ = ticks;
    missed_ = missed;
    updates_ = updates;
    showPace(percentLate, tr("Servo %1 Hz, p99 %2 µs, missed %3, %4  |  surface %5/s")
                              .arg(rate, 0, 'f', 0)
                              .arg(timing.tick.quantile(0.99), 0, 'f', 0)
                              .arg(missed)
                              .arg(runner.feed().isRealTime() ? tr("real-time") : tr("not real-time"))
                              .arg(updateRate, 0, 'f', 0));
    removed_->setText(removedText(runner.feed().removed(), runner.feed().materials()));
    sound_->setText(translated(statusText(sound)));
}

}  // namespace tactooth
