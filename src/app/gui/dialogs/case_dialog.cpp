// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/case_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTextBrowser>

#include "app/gui/dialogs/import_choices.h"
#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

constexpr int kParts = 1000;  // of the progress bar

QString titleOf(const CaseTooth& tooth) {
    const QString name = QString::fromStdString(tooth.name);
    if (tooth.fdi == 0) return CaseDialog::tr("%1, number unknown: choose its quadrant").arg(name);
    return CaseDialog::tr("%1, tooth %2 (FDI)").arg(name).arg(tooth.fdi);
}

QString asList(const QString& title, const std::vector<Message>& sentences) {
    QString list = "<b>" + title.toHtmlEscaped() + "</b><ul>";
    for (const Message& sentence : sentences) list += "<li>" + translated(sentence).toHtmlEscaped() + "</li>";
    return list + "</ul>";
}

}  // namespace

CaseDialog::CaseDialog(const QString& name, QWidget* parent)
    : QDialog(parent),
      state_(new QLabel),
      quadrant_(new QComboBox),
      units_(new QComboBox),
      holes_(new QComboBox),
      inside_(new QComboBox),
      notes_(new QTextBrowser),
      progress_(new QProgressBar),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Make a case from a folder of scans"));
    auto* form = new QFormLayout(this);
    form->addRow(new QLabel("<b>" + name.toHtmlEscaped() + "</b>"));
    state_->setWordWrap(true);
    form->addRow(state_);
    addChoices(*form);
    form->addRow(new QLabel(tr("What the case holds, and what was assumed and repaired:")));
    notes_->setObjectName("caseNotes");
    notes_->setMinimumHeight(220);
    form->addRow(notes_);
    progress_->setObjectName("caseProgress");
    form->addRow(progress_);
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("Save and open…"));
    buttons_->setObjectName("caseButtons");
    form->addRow(buttons_);
    connect(buttons_, &QDialogButtonBox::accepted, this, &CaseDialog::caseAccepted);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    resize(720, sizeHint().height());
    showWork(QString(), 0);
}

void CaseDialog::addChoices(QFormLayout& form) {
    quadrant_->setObjectName("quadrant");
    quadrant_->addItem(tr("As the names of the files say"), QVariant());
    quadrant_->addItem(tr("Upper right (1)"), 1);
    quadrant_->addItem(tr("Upper left (2)"), 2);
    quadrant_->addItem(tr("Lower left (3)"), 3);
    quadrant_->addItem(tr("Lower right (4)"), 4);
    quadrant_->setToolTip(tr("Where a name ends in a single digit, as L6, it is a tooth of this quarter of the mouth"));
    form.addRow(tr("Quadrant"), quadrant_);
    fillUnits(*units_);
    form.addRow(tr("Unit"), units_);
    fillHoles(*holes_);
    form.addRow(tr("Holes"), holes_);
    fillInside(*inside_);
    form.addRow(tr("Inside"), inside_);
    for (QComboBox* box : {quadrant_, units_, holes_, inside_}) {
        connect(box, &QComboBox::currentIndexChanged, this, [this] { emit choicesChanged(); });
    }
}

CaseRequest CaseDialog::request() const {
    CaseRequest request;
    if (quadrant_->currentData().isValid()) request.quadrant = quadrant_->currentData().toInt();
    request.choices.mmPerUnit = chosenUnit(*units_);
    request.choices.holes = chosenHoles(*holes_);
    request.choices.modelsLayers = modelsLayers(*inside_);
    return request;
}

void CaseDialog::showWork(const QString& body, double part) {
    state_->setText(body.isEmpty() ? tr("Reading the surfaces…") : tr("Importing %1…").arg(body));
    progress_->setVisible(true);
    progress_->setRange(0, body.isEmpty() ? 0 : kParts);
    progress_->setValue(static_cast<int>(part * kParts));
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(false);
}

void CaseDialog::showCase(const Expected<NewCase>& made) {
    progress_->setVisible(false);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(made.has_value());
    state_->clear();
    if (!made) return notes_->setPlainText(translated(made.error()));
    const CaseDescription& described = made->description;
    state_->setText(tr("Teeth: %1. Bodies around them: %2.").arg(described.teeth.size()).arg(described.around.size()));
    QString text;
    for (std::size_t i = 0; i < described.teeth.size(); ++i) {
        text += asList(titleOf(described.teeth[i]), made->ofTeeth[i]);
    }
    for (std::size_t i = 0; i < described.around.size(); ++i) {
        text += asList(QString::fromStdString(described.around[i].name), made->ofAround[i]);
    }
    notes_->setHtml(text);
}

}  // namespace tactooth
