// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/event_banner.h"

#include <QAccessible>
#include <QEvent>
#include <QPainter>

#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

constexpr int kPadding = 10;      // pixels
constexpr int kFromTop = 12;      // pixels
constexpr double kLarger = 1.15;  // than the other texts

}  // namespace

EventBanner::EventBanner(QWidget* picture) : QWidget(picture) {
    setObjectName("eventBanner");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    hide();
    gone_.setSingleShot(true);
    connect(&gone_, &QTimer::timeout, this, &QWidget::hide);
    picture->installEventFilter(this);
}

EventBanner::Weight EventBanner::weightOf(CutEventKind kind) {
    switch (kind) {
        case CutEventKind::PulpExposed:
        case CutEventKind::AdjacentCut:
            return Weight::Harm;
        case CutEventKind::DentinReached:
        case CutEventKind::PulpNear:
        case CutEventKind::NeighbourTouched:
        case CutEventKind::GingivaTouched:
        case CutEventKind::BurStalled:
        case CutEventKind::FragmentReleased:
            return Weight::Caution;
        case CutEventKind::FirstContact:
            break;
    }
    return Weight::None;
}

bool EventBanner::announce(CutEventKind kind) {
    constexpr int kCautionMs = 3500, kHarmMs = 7000;
    const Weight weight = weightOf(kind);
    if (weight == Weight::None || (!isHidden() && weight < weight_)) return false;
    weight_ = weight;
    text_ = translated(cutEventText(kind));
    if (!text_.isEmpty()) text_[0] = text_[0].toUpper();
    setAccessibleName(text_);
    QFont larger = font();
    larger.setPointSizeF(kLarger * parentWidget()->font().pointSizeF());
    larger.setBold(true);
    setFont(larger);
    place();
    show();
    raise();
    update();
    gone_.start(weight == Weight::Harm ? kHarmMs : kCautionMs);
    QAccessibleEvent spoken(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&spoken);
    return true;
}

void EventBanner::place() {
    const QSize text = fontMetrics().size(Qt::TextSingleLine, text_);
    const QSize whole = (text + QSize(4 * kPadding, 2 * kPadding)).boundedTo(parentWidget()->size());
    setGeometry((parentWidget()->width() - whole.width()) / 2, kFromTop, whole.width(), whole.height());
}

bool EventBanner::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && !isHidden()) place();
    return QWidget::eventFilter(watched, event);
}

/// White on red for harm, black on amber else: both can be read on every picture, and distinguished without colours.
void EventBanner::paintEvent(QPaintEvent*) {
    const bool isHarm = weight_ == Weight::Harm;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isHarm ? QColor(176, 32, 24) : QColor(255, 196, 61));
    painter.drawRoundedRect(rect(), kPadding, kPadding);
    painter.setPen(isHarm ? Qt::white : Qt::black);
    const QString shown = fontMetrics().elidedText(text_, Qt::ElideRight, width() - 2 * kPadding);
    painter.drawText(rect(), Qt::AlignCenter, shown);
}

}  // namespace tactooth
