// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/status_line.h"

#include <QEvent>
#include <QLocale>
#include <cmath>

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

constexpr int kOverrunSteps = 100;        // of a tenth of a percent: the bar is full when a tenth of all ticks is late
constexpr double kNoticeableOverrun = 1;  // percent

}  // namespace

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent),
      hint_(new ElidedLabel),
      removed_(new QLabel),
      servo_(new QLabel),
      overrun_(new QProgressBar),
      sound_(new QLabel) {
    hint_->setObjectName("hint");
    addWidget(hint_, 1);  // in a small window the numbers keep their space
    for (QWidget* part : std::initializer_list<QWidget*>{removed_, servo_, overrun_, sound_}) addPermanentWidget(part);
    overrun_->setObjectName("overrun");
    overrun_->setRange(0, kOverrunSteps);
    fitMeter();
    overrun_->setToolTip(tr(
        "The share of ticks in the last second that came too late for the force.\nMore than 1 % is felt: close other "
        "programs, or take a tooth with fewer triangles."));
    removed_->setObjectName("removed");
    servo_->setObjectName("servo");
}

void StatusLine::changeEvent(QEvent* event) {
    QStatusBar::changeEvent(event);
    if (event->type() == QEvent::FontChange) fitMeter();
}

void StatusLine::fitMeter() {
    constexpr int kAround = 24;  // pixels
    overrun_->setFixedWidth(fontMetrics().horizontalAdvance(tr("late %1 %").arg("00.0")) + kAround);
}

/// With a large font or in a small window the full texts would leave no space for the hint.
void StatusLine::showServo(const QString& brief, const QString& whole) {
    constexpr double kMost = 0.36;  // of the window
    const bool fits = servo_->fontMetrics().horizontalAdvance(whole) < kMost * width();
    servo_->setText(fits ? whole : brief);
    servo_->setMinimumWidth(servo_->sizeHint().width());  // the status bar would make space for a longer text too late
    servo_->setToolTip(whole + '\n' +
                       tr("The force is computed by a thread of its own, 1000 times a second.\np99: 99 % of the ticks "
                          "take less. Missed: ticks that the system gave no time for."));
}

void StatusLine::showOverrun(std::uint64_t inTime, std::uint64_t missed) {
    const std::uint64_t all = inTime + missed;
    const double percent = all > 0 ? 100 * static_cast<double>(missed) / static_cast<double>(all) : 0;
    const QString text = tr("late %1 %").arg(QLocale().toString(percent, 'f', 1));
    if (text == overrun_->format()) return;
    overrun_->setUpdatesEnabled(false);  // each call below would make the desktop compose the whole window
    overrun_->setValue(std::min(kOverrunSteps, static_cast<int>(std::lround(10 * percent))));
    overrun_->setFormat(text);
    QPalette colours;
    if (percent > kNoticeableOverrun) colours.setColor(QPalette::Highlight, QColor(196, 48, 32));
    overrun_->setPalette(colours);
    overrun_->setUpdatesEnabled(true);
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
    if (counts && missed >= missed_) showOverrun(ticks - ticks_, missed - missed_);
    ticks_ = ticks;
    missed_ = missed;
    updates_ = updates;
    constexpr double kRounding =
        10;  // Hz: a rate that varies would make the desktop compose the whole window each second
    constexpr double kWholeMicroseconds = 5;
    const double shownRate = kRounding * std::round(rate / kRounding);
    showServo(tr("Servo %1 Hz").arg(shownRate, 0, 'f', 0),
              tr("Servo %1 Hz, p99 %2 µs, missed %3, %4  |  surface %5/s")
                  .arg(shownRate, 0, 'f', 0)
                  .arg(kWholeMicroseconds * std::round(timing.tick.quantile(0.99) / kWholeMicroseconds), 0, 'f', 0)
                  .arg(missed)
                  .arg(runner.feed().isRealTime() ? tr("real-time") : tr("not real-time"))
                  .arg(updateRate, 0, 'f', 0));
    removed_->setText(removedText(runner.feed().removed(), runner.feed().materials()));
    sound_->setText(translated(statusText(sound)));
}

}  // namespace tactooth
