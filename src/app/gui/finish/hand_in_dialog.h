// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "app/gui/finish/finished_work.h"

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace tactooth {

/// Asks for what a student hands in with a work, and where.
class HandInDialog final : public QDialog {
    Q_OBJECT

public:
    /// `intro`: a sentence above the fields. `folder`: that is proposed.
    HandInDialog(const QString& intro, const QString& folder, QWidget* parent);

    [[nodiscard]] HandIn handIn() const;
    /// The files are being written: nothing can be changed.
    void setWriting(bool writing);

signals:
    /// The student wants to hand in.
    void wanted();

private:
    void chooseFolder();
    void follow();

    QLineEdit* name_;
    QPlainTextEdit* comment_;
    QLineEdit* folder_;
    QPushButton* browse_;
    QPushButton* write_;
    bool writing_ = false;
};

}  // namespace tactooth
