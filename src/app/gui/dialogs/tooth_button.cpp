// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/tooth_button.h"

#include <QKeyEvent>
#include <QPainter>
#include <array>
#include <utility>

namespace tactooth {
namespace {

constexpr double kPen = 1.4, kFocusPen = 3;  // pixels
constexpr int kAround = 3;                   // pixels: the pen of the focus
constexpr double kDot = 3.4;                 // pixels: radius of the mark of an exercise

QColor mixed(const QColor& a, const QColor& b, double share) {
    const auto part = [share](int from, int to) { return static_cast<int>(from + share * (to - from)); };
    return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

}  // namespace

ToothButton::ToothButton(int fdi, bool loaded, bool hasExercise, QWidget* parent)
    : QAbstractButton(parent), fdi_(fdi), loaded_(loaded), hasExercise_(hasExercise) {
    setObjectName(QString("tooth%1").arg(fdi));
    setFocusPolicy(Qt::ClickFocus);  // one of all teeth takes the Tab key: see ToothChart
    setAttribute(Qt::WA_Hover);
}

void ToothButton::setShape(const QPainterPath& outline, const QPainterPath& lines, const QRectF& number) {
    const QRect all =
        outline.boundingRect().united(number).toAlignedRect().adjusted(-kAround, -kAround, kAround, kAround);
    setGeometry(all);
    const QPointF origin = all.topLeft();
    outline_ = outline.translated(-origin);
    lines_ = lines.translated(-origin);
    number_ = number.translated(-origin);
    // What is outside belongs to the neighbours.
    QPainterPathStroker around;
    around.setWidth(kFocusPen);
    QRegion mask(outline_.toFillPolygon().toPolygon());
    mask += QRegion(around.createStroke(outline_).toFillPolygon().toPolygon(), Qt::WindingFill);
    setMask(mask + QRegion(number_.toAlignedRect()));
    update();
}

bool ToothButton::hitButton(const QPoint& place) const { return outline_.contains(place) || number_.contains(place); }

void ToothButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& colours = palette();
    const QColor text = colours.color(QPalette::WindowText), highlight = colours.color(QPalette::Highlight);
    const QColor plain = colours.color(QPalette::Base);
    const QColor lines = loaded_ ? colours.color(QPalette::HighlightedText) : text;
    const bool isUnderMouse = underMouse();
    painter.setPen(hasFocus() ? QPen(loaded_ ? text : highlight, kFocusPen) : QPen(text, kPen));
    painter.setBrush(loaded_ ? highlight : isUnderMouse ? mixed(plain, highlight, 0.25) : plain);
    painter.drawPath(outline_);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(mixed(loaded_ ? highlight : plain, lines, 0.5), 1, Qt::SolidLine, Qt::RoundCap));
    painter.drawPath(lines_);
    if (hasExercise_) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(loaded_ ? lines : highlight);
        painter.drawEllipse(outline_.boundingRect().center(), kDot, kDot);
    }
    QFont letters = font();
    letters.setBold(loaded_ || hasFocus());
    painter.setFont(letters);
    painter.setPen(text);
    painter.drawText(number_, Qt::AlignCenter, this->text());
}

void ToothButton::keyPressEvent(QKeyEvent* event) {
    constexpr std::array kSteps = {std::pair{Qt::Key_Left, ChartStep::Left}, std::pair{Qt::Key_Right, ChartStep::Right},
                                   std::pair{Qt::Key_Up, ChartStep::Up}, std::pair{Qt::Key_Down, ChartStep::Down}};
    for (const auto& [key, step] : kSteps) {
        if (event->key() == key) return emit arrowPressed(step);
    }
    switch (event->key()) {
        case Qt::Key_Home:
        case Qt::Key_End:
            return emit endPressed(event->key() == Qt::Key_End);
        case Qt::Key_Return:
        case Qt::Key_Enter:
            return click();
        default:
            break;
    }
    const QString typed = event->text();
    if (!typed.isEmpty() && typed[0].isLetterOrNumber()) return emit lettersTyped(typed);
    QAbstractButton::keyPressEvent(event);
}

void ToothButton::enterEvent(QEnterEvent* event) {
    QAbstractButton::enterEvent(event);
    emit entered();
}

void ToothButton::leaveEvent(QEvent* event) {
    QAbstractButton::leaveEvent(event);
    update();
}

void ToothButton::focusInEvent(QFocusEvent* event) {
    QAbstractButton::focusInEvent(event);
    emit entered();
}

}  // namespace tactooth
