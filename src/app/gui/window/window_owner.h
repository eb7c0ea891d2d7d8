// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "app/gui/settings/window_settings.h"

class QApplication;

namespace tactooth {

class MainWindow;
class SoundOutput;

/// Holds the program's window. Whoever chooses another language gets a window that speaks it at once, with the tooth
/// and its cuts, the bur, and all that was set; a target of one's own has to be chosen again.
class WindowOwner final : public QObject {
    Q_OBJECT

public:
    /// Both outlive the holder.
    WindowOwner(QApplication& application, SoundOutput& sound);
    ~WindowOwner() override;

    /// Makes the window, in the language of `settings`; it is not shown yet.
    MainWindow& open(const WindowSettings& settings);
    /// Until the next change of the language.
    [[nodiscard]] MainWindow& window() { return *window_; }

signals:
    /// MainWindow::graphicsFailed.
    void graphicsFailed(const QString& sentence);

private:
    void reopen();

    QApplication& application_;
    SoundOutput& sound_;
    std::unique_ptr<MainWindow> window_;
};

}  // namespace tactooth
