// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace tactooth {

/// The welcome at the first start, with three ways to begin. Closing it means practise.
class WelcomeDialog final : public QDialog {
    Q_OBJECT

public:
    explicit WelcomeDialog(QWidget* parent = nullptr);

signals:
    void toothRequested();
    void demonstrationRequested();

private:
    void addChoice(const QString& title, const QString& what, const char* name, void (WelcomeDialog::*requested)());
};

}  // namespace tactooth
