// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_slider.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyleOptionSlider>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace tactooth {
namespace {

constexpr double kStepsPerSecond = 1000;
constexpr int kMarkWidth = 2;     // pixels
constexpr double kMarkReach = 5;  // pixels, in which the mouse finds a mark
constexpr int kArrowStep = 100;   // ms
constexpr int kPageStep = 5000;   // ms

int stepsOf(double time) { return static_cast<int>(std::lround(kStepsPerSecond * time)); }

/// The part of the slider in which the middle of the handle moves.
std::pair<int, int> travelOf(const QSlider& slider, const QStyleOptionSlider& option) {
    const QStyle& style = *slider.style();
    const QRect groove = style.subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, &slider);
    const int handle = style.pixelMetric(QStyle::PM_SliderLength, &option, &slider);
    return {groove.left() + handle / 2, std::max(1, groove.width() - handle)};
}

}  // namespace

ReplaySlider::ReplaySlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
    setObjectName("replayTime");
    setAccessibleName(tr("Time of the recording"));
    setToolTip(tr("Time of the recording; the marks are events and comments"));
    setRange(0, 0);
    setSingleStep(kArrowStep);
    setPageStep(kPageStep);
    setMinimumWidth(160);
    connect(this, &QSlider::valueChanged, this, [this](int value) { emit timeChosen(value / kStepsPerSecond); });
}

void ReplaySlider::setMarks(std::vector<Mark> marks) {
    if (marks == marks_) return;
    marks_ = std::move(marks);
    update();
}

void ReplaySlider::setLength(double length, double ready) {
    if (length == length_ && ready == ready_) return;
    length_ = length;
    ready_ = ready;
    const QSignalBlocker quiet(this);
    setMaximum(stepsOf(length));
    update();
}

void ReplaySlider::show(double time) {
    if (isSliderDown()) return;
    const QSignalBlocker quiet(this);
    setValue(stepsOf(time));
}

double ReplaySlider::timeAt(double x) const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const auto [left, width] = travelOf(*this, option);
    return std::clamp((x - left) / width, 0.0, 1.0) * length_;
}

double ReplaySlider::xOf(double time) const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const auto [left, width] = travelOf(*this, option);
    return left + (length_ > 0 ? time / length_ : 0) * width;
}

void ReplaySlider::paintEvent(QPaintEvent* event) {
    {
        QPainter painter(this);
        const int ready = static_cast<int>(xOf(ready_));
        QColor missing = palette().color(QPalette::Mid);
        missing.setAlpha(90);
        if (ready_ < length_) painter.fillRect(QRect(ready, 0, width() - ready, height()), missing);
        for (const Mark& mark : marks_) {
            const int x = static_cast<int>(xOf(mark.time)) - kMarkWidth / 2;
            const QColor colour = mark.isComment ? QColor(214, 120, 20) : palette().color(QPalette::Highlight);
            painter.fillRect(QRect(x, mark.isComment ? height() / 2 : 0, kMarkWidth, height() / 2), colour);
        }
    }
    QSlider::paintEvent(event);
}

/// A click goes to that time, as in players of films.
void ReplaySlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) setValue(stepsOf(timeAt(event->position().x())));
    QSlider::mousePressEvent(event);
}

bool ReplaySlider::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QSlider::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QStringList texts;
    for (const Mark& mark : marks_) {
        if (std::abs(xOf(mark.time) - help->pos().x()) > kMarkReach) continue;
        texts << QString("%1 s: %2").arg(locale().toString(mark.time, 'f', 1), mark.text.toHtmlEscaped());
    }
    constexpr qsizetype kMost = 6;
    QToolTip::showText(help->globalPos(),
                       texts.isEmpty() ? toolTip() : "<p>" + texts.mid(0, kMost).join("<br>") + "</p>", this);
    return true;
}

}  // namespace tactooth
