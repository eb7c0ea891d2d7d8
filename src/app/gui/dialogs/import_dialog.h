// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QLabel>
#include <QProgressBar>
#include <QTextBrowser>

#include "patient/scan_import.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;

namespace tactooth {

/// Shows what was assumed about a scan before it is taken, and lets the person change it. Does no work itself: it says
/// what is wanted, and is told what came of it.
class ImportDialog final : public QDialog {
    Q_OBJECT

public:
    /// `name`: of the scan; `caseFile`: where it can be kept as a case.
    ImportDialog(const QString& name, const QString& caseFile, QWidget* parent = nullptr);

    [[nodiscard]] ImportOptions choices() const;
    /// Whether the person wants the case file.
    [[nodiscard]] bool savesCase() const;

    /// The scan is being looked at.
    void showExamining(bool isReading);
    /// What was found, or why it cannot be taken with these choices.
    void showFindings(const Expected<ExaminedScan>& scan);
    /// The layers are being made; `part` of it is done.
    void showBuilding(double part);

signals:
    void choicesChanged();
    /// The person takes the scan as it was shown.
    void importAccepted();

private:
    void addChoices(QFormLayout& form);
    void setEnabledAll(bool enabled);

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
