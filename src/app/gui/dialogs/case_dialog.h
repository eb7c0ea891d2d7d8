// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "session/cases/make_case.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QTextBrowser;

namespace tactooth {

/// Makes a case from a folder of scans: asks for what the surfaces do not say, and shows what was assumed before the
/// case is written. It does no work itself: CaseMaker does it and reports here.
class CaseDialog final : public QDialog {
    Q_OBJECT

public:
    /// `name`: of the folder.
    explicit CaseDialog(const QString& name, QWidget* parent = nullptr);

    /// The choices of the user; `from` and `title` are empty.
    [[nodiscard]] CaseRequest request() const;

    /// The surface `body` is being imported, `part` of it is done, 0..1.
    void showWork(const QString& body, double part);
    /// Shows what the case holds and what was assumed, or why it cannot be made with these choices.
    void showCase(const Expected<NewCase>& made);

signals:
    void choicesChanged();
    /// The user accepts the case as shown.
    void caseAccepted();

private:
    void addChoices(QFormLayout& form);

    QLabel* state_;
    QComboBox* quadrant_;
    QComboBox* units_;
    QComboBox* holes_;
    QComboBox* inside_;
    QTextBrowser* notes_;
    QProgressBar* progress_;
    QDialogButtonBox* buttons_;
};

}  // namespace tactooth
