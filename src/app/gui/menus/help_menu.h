// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMenuBar;
class QWidget;

namespace tactooth {

class GuidedTour;
class KeyController;
class ManualController;
class ToothController;
class WindowMessages;

/// The help menu and its dialogs.
class HelpMenu final : public QObject {
    Q_OBJECT

public:
    /// Adds the menu to `bar`. All others outlive it; `window` is the parent of its dialogs.
    HelpMenu(QMenuBar& bar, QWidget& window, ToothController& teeth, GuidedTour& tour, WindowMessages& messages,
             const KeyController& keys, ManualController& manual);

    /// Shows three ways to begin.
    void welcome();

private:
    void showMouseAndKeys();
    void showAbout();

    QWidget& window_;
    ToothController& teeth_;
    GuidedTour& tour_;
    WindowMessages& messages_;
    const KeyController& keys_;
    ManualController& manual_;
};

}  // namespace tactooth
