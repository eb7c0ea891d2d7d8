// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

#include "app/gui/settings/window_settings.h"

class QAction;
class QWidget;

namespace tactooth {

class AppearanceMenu;
class ExerciseController;
class FileMenu;
class GuidedTour;
class ManualController;
class RecordingController;
class ToothController;
class WelcomeDialog;

/// Opens the page at the start: from the menus, by a key, or as the program begins.
class WelcomeEntry final : public QObject {
    Q_OBJECT

public:
    /// What the page leads to; all of them outlive it. `window` is the parent of the page.
    struct Parts {
        QWidget& window;
        ToothController& teeth;
        ExerciseController& exercise;
        RecordingController& recordings;
        FileMenu& files;
        AppearanceMenu& appearance;
        ManualController& manual;
        GuidedTour& tour;
    };
    explicit WelcomeEntry(const Parts& parts);

    [[nodiscard]] QAction& action() const { return *action_; }
    void open();
    /// Whether the page is open.
    [[nodiscard]] bool isOpen() const;
    /// Whether the page comes at each start.
    [[nodiscard]] bool comesAtStart() const { return comesAtStart_; }
    void restore(const WindowSettings& settings) { comesAtStart_ = settings.welcome; }
    void store(WindowSettings& settings) const { settings.welcome = comesAtStart_; }

private:
    Parts parts_;
    QAction* action_;
    QPointer<WelcomeDialog> page_;
    bool comesAtStart_ = true;
};

}  // namespace tactooth
