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
class WelcomeEntry;
class WindowMessages;

/// The help menu and its dialogs.
class HelpMenu final : public QObject {
    Q_OBJECT

public:
    /// Adds the menu to `bar`. All others outlive it; `window` is the parent of its dialogs.
    HelpMenu(QMenuBar& bar, QWidget& window, const WelcomeEntry& welcome, GuidedTour& tour, WindowMessages& messages,
             const KeyController& keys, ManualController& manual);

private:
    void showMouseAndKeys();
    void showAbout();

    QWidget& window_;
    WindowMessages& messages_;
    const KeyController& keys_;
};

}  // namespace tactooth
