// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QLabel>
#include <QProgressBar>
#include <QTextBrowser>

#include "collision/bvh/surface.h"
#include "patient/scan_import.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;

namespace tactooth {

class ScanPreview;

/// Shows the assumptions about a scan before the import, and lets the user change them. It does no work itself:
/// ScanImporter does it and reports here.
class ImportDialog final : public QDialog {
    Q_OBJECT

public:
    /// `name`: of the scan; `caseFile`: where the scan can be saved as a case.
    ImportDialog(const QString& name, const QString& caseFile, QWidget* parent = nullptr);

    [[nodiscard]] ImportOptions choices() const;
    /// Whether the user wants the case file.
    [[nodiscard]] bool savesCase() const;

    /// The scan is being examined.
    void showExamining(bool isReading);
    /// Shows the findings, or why the scan cannot be imported with these choices.
    /// `surface`: that of the scan in the tooth frame; null without a scan.
    void showFindings(const Expected<ExaminedScan>& scan, std::shared_ptr<const Surface> surface);
    /// The layers are being made; `part` of the work is done, 0..1.
    void showBuilding(double part);

signals:
    void choicesChanged();
    /// The user accepts the scan as shown.
    void importAccepted();

private:
    void addChoices(QFormLayout& form);
    void turnTo(double azimuth);
    void setEnabledAll(bool enabled);

    ScanPreview* preview_;
    QLabel* state_;
    QTextBrowser* importNotes_;
    QProgressBar* progress_;
    QComboBox* units_;
    QCheckBox* upsideDown_;
    QDoubleSpinBox* turn_;
    QComboBox* holes_;
    QComboBox* inside_;
    QCheckBox* keep_;
    QDialogButtonBox* buttons_;
};

}  // namespace tactooth
