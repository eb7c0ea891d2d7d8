// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>

#include "app/gui/dialogs/import_choices.h"
#include "app/gui/dialogs/scan_preview.h"
#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

constexpr int kParts = 1000;  // of the progress bar

QString millimetres(double length) { return QString::number(length, 'f', 1); }

}  // namespace

ImportDialog::ImportDialog(const QString& name, const QString& caseFile, QWidget* parent)
    : QDialog(parent),
      preview_(new ScanPreview),
      state_(new QLabel),
      importNotes_(new QTextBrowser),
      progress_(new QProgressBar),
      units_(new QComboBox),
      upsideDown_(new QCheckBox(tr("Crown and root the other way up"))),
      turn_(new QDoubleSpinBox),
      holes_(new QComboBox),
      inside_(new QComboBox),
      keep_(new QCheckBox(tr("Also keep it as a case: %1").arg(QFileInfo(caseFile).fileName()))),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Import a scan"));
    auto* halves = new QHBoxLayout(this);
    auto* left = new QVBoxLayout;
    left->addWidget(preview_, 1);
    auto* hint = new QLabel(tr("Click on the side of the cheek or lip: it becomes buccal (B)."));
    hint->setWordWrap(true);
    left->addWidget(hint);
    halves->addLayout(left, 2);
    auto* form = new QFormLayout;
    halves->addLayout(form, 3);
    auto* title = new QLabel("<b>" + name.toHtmlEscaped() + "</b>");
    form->addRow(title);
    form->addRow(state_);
    addChoices(*form);
    form->addRow(new QLabel(tr("What was assumed and repaired:")));
    importNotes_->setObjectName("importNotes");
    importNotes_->setMinimumHeight(200);
    form->addRow(importNotes_);
    keep_->setObjectName("keepCase");
    keep_->setToolTip(caseFile);
    form->addRow(keep_);
    progress_->setObjectName("importProgress");
    progress_->setRange(0, 0);
    form->addRow(progress_);
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("Import"));
    buttons_->setObjectName("importButtons");
    form->addRow(buttons_);
    connect(buttons_, &QDialogButtonBox::accepted, this, &ImportDialog::importAccepted);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(preview_, &ScanPreview::cheekChosen, this, &ImportDialog::turnTo);
    resize(980, sizeHint().height());
    showExamining(true);
}

void ImportDialog::addChoices(QFormLayout& form) {
    fillUnits(*units_);
    form.addRow(tr("Unit"), units_);
    upsideDown_->setObjectName("upsideDown");
    form.addRow(QString(), upsideDown_);
    turn_->setObjectName("turn");
    turn_->setRange(-180, 180);
    turn_->setSingleStep(15);
    turn_->setDecimals(0);
    turn_->setSuffix("°");
    turn_->setKeyboardTracking(false);
    form.addRow(tr("Turn about the long axis"), turn_);
    fillHoles(*holes_);
    form.addRow(tr("Holes"), holes_);
    fillInside(*inside_);
    form.addRow(tr("Inside"), inside_);
    const auto say = [this] { emit choicesChanged(); };
    for (QComboBox* box : {units_, holes_, inside_}) connect(box, &QComboBox::currentIndexChanged, this, say);
    connect(upsideDown_, &QCheckBox::toggled, this, say);
    connect(turn_, &QDoubleSpinBox::valueChanged, this, say);
}

/// The place at `azimuth` comes to where the cheek is.
void ImportDialog::turnTo(double azimuth) {
    if (!turn_->isEnabled()) return;
    constexpr double kCheek = 90;  // degrees
    const double turn = turn_->value() + kCheek - azimuth * 180 / std::numbers::pi;
    turn_->setValue(std::remainder(std::round(turn), 360.0));
}

ImportOptions ImportDialog::choices() const {
    ImportOptions choices;
    choices.mmPerUnit = chosenUnit(*units_);
    choices.frame.isFlipped = upsideDown_->isChecked();
    choices.frame.turn = turn_->value() * std::numbers::pi / 180;
    choices.holes = chosenHoles(*holes_);
    choices.modelsLayers = modelsLayers(*inside_);
    return choices;
}

bool ImportDialog::savesCase() const { return keep_->isChecked(); }

void ImportDialog::setEnabledAll(bool enabled) {
    for (QWidget* choice :
         {static_cast<QWidget*>(units_), static_cast<QWidget*>(upsideDown_), static_cast<QWidget*>(turn_),
          static_cast<QWidget*>(holes_), static_cast<QWidget*>(inside_), static_cast<QWidget*>(keep_)}) {
        choice->setEnabled(enabled);
    }
}

void ImportDialog::showExamining(bool isReading) {
    state_->setText(isReading ? tr("Reading the surface…") : tr("Looking at the surface…"));
    progress_->setRange(0, 0);
    progress_->setVisible(true);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(false);
}

void ImportDialog::showFindings(const Expected<ExaminedScan>& scan, std::shared_ptr<const Surface> surface) {
    preview_->show(std::move(surface));
    progress_->setVisible(false);
    setEnabledAll(true);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(scan.has_value());
    if (!scan) {
        state_->clear();
        importNotes_->setPlainText(translated(scan.error()));
        return;
    }
    const Vec3 size = boundingBox(scan->outer).sizes();
    state_->setText(tr("%1 triangles, %2 x %3 x %4 mm")
                        .arg(scan->outer.triangles.size())
                        .arg(millimetres(size.x()), millimetres(size.y()), millimetres(size.z())));
    QString list;
    for (const ImportNote& importNote : scan->importNotes)
        list += "<li>" + translated(importNote.message).toHtmlEscaped() + "</li>";
    importNotes_->setHtml("<ul>" + list + "</ul>");
}

void ImportDialog::showBuilding(double part) {
    state_->setText(tr("Making the layers inside the tooth…"));
    setEnabledAll(false);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(false);
    progress_->setVisible(true);
    progress_->setRange(0, kParts);
    progress_->setValue(static_cast<int>(part * kParts));
}

}  // namespace tactooth
