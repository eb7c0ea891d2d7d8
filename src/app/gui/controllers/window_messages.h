// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMessageBox>
#include <QObject>

#include "geometry/util/expected.h"

namespace tactooth {

class StatusLine;

/// What the window shows the user: the hint in the status line, and messages that do not stop the simulation.
class WindowMessages final : public QObject {
    Q_OBJECT

public:
    /// Both outlive the messages.
    WindowMessages(StatusLine& status, QWidget& window) : status_(status), window_(window) {}

    /// Stays in the status line until the next hint.
    void setHint(const QString& hint);
    void showError(const QString& sentence);
    /// Translates the error first.
    void showError(const Error& error);
    /// After a file was written (FileWriter): the hint, or why there is none.
    void showWritten(const Expected<bool>& written, const QString& hint);
    void show(QMessageBox::Icon icon, const QString& title, const QString& text);
    /// The program ends: nobody reads any more.
    void silence() { isSilent_ = true; }

private:
    StatusLine& status_;
    QWidget& window_;
    bool isSilent_ = false;
};

}  // namespace tactooth
