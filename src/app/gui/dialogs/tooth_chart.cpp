// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/tooth_chart.h"

#include <QApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/dialogs/tooth_button.h"
#include "app/gui/text/translation.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kUsualScale = 4;    // pixels for each mm
constexpr double kLeastScale = 2.6;  // the numbers of the lower incisors just stand beside each other
constexpr double kToNumber = 3.8;    // mm from the outline to the middle of the number

QPainterPath pathThrough(const std::vector<QPointF>& places) {
    QPainterPath path(places.front());
    for (const QPointF& place : places) path.lineTo(place);
    return path;
}

/// How far the tooth reaches from its middle to the cheek, mm.
double reach(const ChartTooth& tooth) {
    double most = 0;
    for (const Vec2& corner : tooth.outline) most = std::max(most, (corner - tooth.centre).dot(tooth.outward));
    return most;
}

}  // namespace

ToothChart::ToothChart(ToothChartMarks marks, ToothNotation notation, QWidget* parent)
    : QWidget(parent), layout_(toothChartLayout()), marks_(std::move(marks)), notation_(notation) {
    setObjectName("toothChart");
    setAccessibleName(tr("Tooth chart"));
    for (std::size_t i = 0; i < layout_.teeth.size(); ++i) {
        const int fdi = layout_.teeth[i].fdi;
        auto* tooth = new ToothButton(fdi, fdi == marks_.loaded, marks_.exercises.contains(fdi), this);
        buttons_[i] = tooth;
        connect(tooth, &ToothButton::clicked, this, [this, fdi] { emit chosen(fdi); });
        connect(tooth, &ToothButton::entered, this, [this, fdi] { emit described(description(fdi)); });
        connect(tooth, &ToothButton::arrowPressed, this, [this, fdi](ChartStep step) { goTo(toothBeside(fdi, step)); });
        connect(tooth, &ToothButton::endPressed, this, [this, i](bool last) {
            const std::size_t row = i < ToothChartLayout::kTeeth / 2 ? 0 : ToothChartLayout::kTeeth / 2;
            goTo(layout_.teeth[row + (last ? ToothChartLayout::kTeeth / 2 - 1 : 0)].fdi);
        });
        connect(tooth, &ToothButton::lettersTyped, this, &ToothChart::type);
    }
    nameButtons();
}

void ToothChart::setNotation(ToothNotation notation) {
    notation_ = notation;
    typed_.clear();
    nameButtons();
    place();
}

ToothButton& ToothChart::button(int fdi) const {
    const auto* const found = std::ranges::find(layout_.teeth, fdi, &ChartTooth::fdi);
    TACTOOTH_ASSERT(found != layout_.teeth.end());
    return *buttons_[static_cast<std::size_t>(found - layout_.teeth.begin())];
}

void ToothChart::goTo(int fdi) {
    for (ToothButton* each : buttons_) each->setFocusPolicy(each->fdi() == fdi ? Qt::StrongFocus : Qt::ClickFocus);
    button(fdi).setFocus(Qt::OtherFocusReason);
    emit described(description(fdi));  // a window behind another reports no focus
}

void ToothChart::nameButtons() {
    for (ToothButton* tooth : buttons_) {
        const QString text = description(tooth->fdi());
        tooth->setText(QString::fromStdString(toothLabel(tooth->fdi(), notation_)));
        tooth->setToolTip(text);
        tooth->setAccessibleName(text);
    }
}

QString ToothChart::description(int fdi) const {
    QString text = tr("%1: %2").arg(QString::fromStdString(toothLabel(fdi, notation_)), translated(toothTitle(fdi)));
    if (fdi == marks_.loaded) text += tr(", on the bench");
    const auto exercises = marks_.exercises.find(fdi);
    if (exercises != marks_.exercises.end()) text += tr("; exercise: %1").arg(exercises->second.join(", "));
    return text;
}

/// The number that was typed goes to its tooth as soon as it names one. A pause begins another number.
void ToothChart::type(const QString& letters) {
    const bool isNew = !sinceTyped_.isValid() || sinceTyped_.elapsed() > QApplication::keyboardInputInterval() * 3;
    sinceTyped_.start();
    typed_ = (isNew ? QString() : typed_) + letters.toUpper();
    for (QString part = typed_; !part.isEmpty(); part.remove(0, 1)) {
        if (const auto fdi = toothNamed(part.toStdString(), notation_)) return goTo(*fdi);
    }
}

double ToothChart::pixelsPerMm() const { return std::min(width() / layout_.size.x(), height() / layout_.size.y()); }

/// In the middle of the widget.
QPointF ToothChart::onWidget(const Vec2& place) const {
    const Vec2 from = pixelsPerMm() * (place - layout_.size / 2);
    return {from.x() + width() / 2.0, from.y() + height() / 2.0};
}

void ToothChart::place() {
    QFont bold = font();
    bold.setBold(true);
    const QFontMetrics metrics(bold);
    for (std::size_t i = 0; i < layout_.teeth.size(); ++i) {
        const ChartTooth& tooth = layout_.teeth[i];
        const auto path = [this](const std::vector<Vec2>& corners) {
            std::vector<QPointF> places;
            for (const Vec2& corner : corners) places.push_back(onWidget(corner));
            return pathThrough(places);
        };
        QPainterPath outline = path(tooth.outline), lines;
        outline.closeSubpath();
        for (const auto& line : tooth.lines) lines.addPath(path(line));
        QRectF number(QPointF(), QSizeF(metrics.horizontalAdvance(buttons_[i]->text()) + 2, metrics.height()));
        number.moveCenter(onWidget(tooth.centre + (reach(tooth) + kToNumber) * tooth.outward));
        buttons_[i]->setShape(outline, lines, number);
    }
}

QSize ToothChart::sizeHint() const {
    const double scale = std::max(kUsualScale, 0.27 * fontMetrics().height());
    return {static_cast<int>(std::ceil(scale * layout_.size.x())),
            static_cast<int>(std::ceil(scale * layout_.size.y()))};
}

QSize ToothChart::minimumSizeHint() const { return (kLeastScale / kUsualScale * QSizeF(sizeHint())).toSize(); }

void ToothChart::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    place();
}

void ToothChart::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) place();
}

/// The sides, in the middle of the arches, and a line between left and right.
void ToothChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor faint = palette().color(QPalette::WindowText);
    faint.setAlpha(90);
    painter.setPen(QPen(faint, 1, Qt::DashLine));
    const Vec2 size = layout_.size;
    painter.drawLine(onWidget(Vec2(0.5 * size.x(), 0.24 * size.y())), onWidget(Vec2(0.5 * size.x(), 0.76 * size.y())));
    painter.drawLine(onWidget(Vec2(0.08 * size.x(), 0.5 * size.y())), onWidget(Vec2(0.92 * size.x(), 0.5 * size.y())));
    painter.setPen(palette().color(QPalette::WindowText));
    const auto write = [&](double x, double y, const QString& text) {
        QRectF box(0, 0, 0.36 * pixelsPerMm() * size.x(), 3.0 * fontMetrics().height());
        box.moveCenter(onWidget(Vec2(x * size.x(), y * size.y())));
        painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, text);
    };
    write(0.36, 0.42, tr("Upper right"));
    write(0.64, 0.42, tr("Upper left"));
    write(0.36, 0.58, tr("Lower right"));
    write(0.64, 0.58, tr("Lower left"));
}

}  // namespace tactooth
