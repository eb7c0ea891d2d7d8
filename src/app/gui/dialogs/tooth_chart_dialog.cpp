// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/tooth_chart_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScreen>
#include <QVBoxLayout>

namespace tactooth {
namespace {

constexpr int kFirstTooth = 46;  // has the focus where the loaded tooth has no number

}  // namespace

ToothChartDialog::ToothChartDialog(const ToothChartMarks& marks, ToothNotation notation, QWidget* parent)
    : QDialog(parent), chart_(new ToothChart(marks, notation)), name_(new QLabel) {
    setObjectName("toothChartDialog");
    setWindowTitle(tr("Tooth chart"));
    setAttribute(Qt::WA_DeleteOnClose);
    name_->setObjectName("toothName");
    name_->setAlignment(Qt::AlignCenter);
    name_->setWordWrap(true);
    name_->setMinimumHeight(2 * fontMetrics().lineSpacing());  // an exercise takes a second line
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(makeHead(notation));
    column->addWidget(chart_, 1);
    column->addWidget(name_);
    column->addWidget(makeLegend());
    column->addWidget(buttons);
    connect(chart_, &ToothChart::described, name_, &QLabel::setText);
    connect(chart_, &ToothChart::chosen, this, [this](int fdi) {
        accept();
        emit chosen(fdi);  // may ask about unsaved cuts, in front of the window
    });
    constexpr double kShare = 0.9;  // of the screen at most
    resize(sizeHint().boundedTo(kShare * parent->screen()->availableSize()));
    chart_->goTo(marks.loaded != 0 ? marks.loaded : kFirstTooth);
}

QWidget* ToothChartDialog::makeHead(ToothNotation notation) {
    notations_ = new QComboBox;
    notations_->setObjectName("notation");
    notations_->addItem(tr("FDI (11 to 48)"), static_cast<int>(ToothNotation::Fdi));
    notations_->addItem(tr("Universal (1 to 32)"), static_cast<int>(ToothNotation::Universal));
    notations_->addItem(tr("Palmer (1 to 8 with a corner)"), static_cast<int>(ToothNotation::Palmer));
    notations_->setCurrentIndex(notations_->findData(static_cast<int>(notation)));
    auto* title = new QLabel(tr("&Numbers"));
    title->setBuddy(notations_);
    connect(notations_, &QComboBox::currentIndexChanged, this, [this] {
        const auto chosenNotation = static_cast<ToothNotation>(notations_->currentData().toInt());
        chart_->setNotation(chosenNotation);
        emit notationChosen(chosenNotation);
    });
    auto* head = new QWidget;
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins({});
    row->addStretch();
    row->addWidget(title);
    row->addWidget(notations_);
    row->addStretch();
    return head;
}

QWidget* ToothChartDialog::makeLegend() const {
    const QString colour = palette().color(QPalette::Highlight).name();
    const auto sign = [&colour](const QString& glyph, const QString& meaning) {
        return QString("<span style='color:%1'>%2</span>&nbsp;%3").arg(colour, glyph, meaning.toHtmlEscaped());
    };
    auto* legend = new QLabel(sign(QStringLiteral("\u25a0"), tr("on the bench")) + "&nbsp;&nbsp;&nbsp; " +
                              sign(QStringLiteral("\u25cf"), tr("has an exercise")));
    legend->setAlignment(Qt::AlignCenter);
    return legend;
}

}  // namespace tactooth
