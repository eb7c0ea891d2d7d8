// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/ideal_box.h"

#include <QLocale>
#include <QVBoxLayout>
#include <cmath>

#include "session/model/tip_measure.h"

namespace tactooth {
namespace {

constexpr int kPercent = 100;

/// To a hundredth, rounded down: what is too little never looks enough.
QString millimetres(double value) {
    constexpr double kShown = 100;  // hundredths of a mm
    return QLocale().toString(std::floor(value * kShown) / kShown, 'f', 2);
}

}  // namespace

IdealBox::IdealBox() : QGroupBox(tr("Ideal cavity")), shows_(new QCheckBox(tr("Show the ideal"))), state_(new QLabel) {
    shows_->setObjectName("showIdeal");
    shows_->setToolTip(tr(
        "The cavity that the outline, the fields and the bur make now, as blue glass in the tooth, darker the deeper "
        "it lies, as the student sees it"));
    shows_->setChecked(true);
    state_->setObjectName("idealState");
    state_->setWordWrap(true);
    state_->setTextFormat(Qt::RichText);
    state_->setMinimumHeight(2 * fontMetrics().lineSpacing());  // so that the fields do not jump
    state_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->addWidget(shows_);
    column->addWidget(state_);
    connect(shows_, &QCheckBox::toggled, this, &IdealBox::chosen);
}

void IdealBox::show(const DraftIdeal& ideal, bool opensPulp) {
    if (ideal.cavity()) return showCavity(*ideal.cavity(), opensPulp);
    if (!ideal.isPreparing()) return state_->setText(tr("There is no ideal cavity yet."));
    const int percent = static_cast<int>(ideal.share() * kPercent);
    state_->setText(tr("The ideal cavity is being prepared… %1 %").arg(percent));
}

void IdealBox::showCavity(const IdealCavity& cavity, bool opensPulp) {
    if (!cavity.toPulp) return state_->setText(tr("This tooth has no pulp."));
    const double left = *cavity.toPulp;
    if (left <= 0) {
        const QString sentence = tr("The ideal cavity opens the pulp.");
        return opensPulp ? state_->setText(sentence) : warn(sentence);
    }
    if (left >= kAtPulp || opensPulp) {
        return state_->setText(tr("Least remaining dentin over the pulp: %1 mm").arg(millimetres(left)));
    }
    warn(tr("Only %1 mm of dentin remains over the pulp: less than %2 mm barely shields it.")
             .arg(millimetres(left), QLocale().toString(kAtPulp)));
}

/// A lamp with words, so that nobody has to tell its colours apart.
void IdealBox::warn(const QString& sentence) {
    state_->setText(QString("<span style=\"color:#d04030\">●</span> <b>%1</b>").arg(sentence.toHtmlEscaped()));
}

}  // namespace tactooth
