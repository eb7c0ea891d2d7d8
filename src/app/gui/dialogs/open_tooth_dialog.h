// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QLineEdit>
#include <map>
#include <string>

#include "session/simulation/tooth_source.h"

class QGridLayout;

namespace tactooth {

/// Asks for the files of a tooth: its surface and, optionally, the layers inside.
class OpenToothDialog final : public QDialog {
    Q_OBJECT

public:
    /// `folder`: in which the file dialogs begin.
    explicit OpenToothDialog(QString folder, QWidget* parent = nullptr);

signals:
    void chosen(const ToothSource& source);

private:
    QLineEdit* addRow(QGridLayout& grid, const QString& label, const QString& tip);
    void emitChosen();

    QString folder_;
    QLineEdit* outer_;
    std::map<std::string, QLineEdit*> layers_;  // by the name of the material
};

}  // namespace tactooth
