// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/status_line.h"

#include <QLocale>
#include <cmath>

#include "app/gui/words.h"

namespace tactooth {
namespace {

QString removedText(const MaterialVolumes& removed) {
    QStringList parts;
    for (std::size_t i = 0; i < removed.size(); ++i) {
        constexpr double kShown = 0.005;  // mm^3: less would be shown as 0.00
        if (removed[i] < kShown) continue;
        const std::string_view name = materialName(static_cast<MaterialId>(i));
        parts += translated(name) + ' ' + QLocale().toString(removed[i], 'f', 2);
    }
    if (parts.isEmpty()) return StatusLine::tr("Nothing removed yet");
    return StatusLine::tr("Removed: %1 mm³").arg(parts.join(", "));
}

}  // namespace

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent), hint_(new QLabel), removed_(new QLabel), servo_(new QLabel), sound_(new QLabel) {
    addWidget(hint_, 1);
    hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // in a small window the numbers come first
    for (QLabel* label : {removed_, servo_, sound_}) addPermanentWidget(label);
    removed_->setObjectName("removed");
    servo_->setObjectName("servo");
    servo_->setToolTip(
        tr("The force is computed by a thread of its own, 1000 times a second.\np99: 99 % of the ticks "
           "take less. Missed: ticks that the system gave no time for."));
}

void StatusLine::show(const Simulator& simulator, SoundStatus sound) {
    const ServoTiming& timing = simulator.timing();
    const std::uint64_t ticks = timing.ticks.load(std::memory_order_relaxed);
    const std::uint64_t updates = simulator.surfaceUpdates();
    const double seconds = since_.isValid() ? static_cast<double>(since_.restart()) / 1000 : (since_.start(), 0.0);
    // A new simulator counts from zero again.
    const bool counts = seconds > 0 && ticks >= ticks_ && updates >= updates_;
    const double rate = counts ? static_cast<double>(ticks - ticks_) / seconds : 0;
    const double updateRate = counts ? static_cast<double>(updates - updates_) / seconds : 0;
    ticks_ = ticks;
    updates_ = updates;
    constexpr double kRounding = 10;  // Hz: a rate that trembles would have the whole window composed anew each second
    servo_->setText(tr("Servo %1 Hz, p99 %2 µs, missed %3, %4  |  surface %5/s")
                        .arg(kRounding * std::round(rate / kRounding), 0, 'f', 0)
                        .arg(timing.tick.quantile(0.99), 0, 'f', 0)
                        .arg(timing.missed.load(std::memory_order_relaxed))
                        .arg(simulator.isRealTime() ? tr("real-time") : tr("not real-time"))
                        .arg(updateRate, 0, 'f', 0));
    servo_->setMinimumWidth(servo_->sizeHint().width());  // the bar would lay out a longer text too late
    removed_->setText(removedText(simulator.removed()));
    const std::string_view text = statusText(sound);
    sound_->setText(translated(text));
}

}  // namespace tactooth
