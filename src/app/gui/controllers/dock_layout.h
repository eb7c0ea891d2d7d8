// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>

#include "app/gui/controllers/window_panels.h"
#include "app/gui/settings/window_settings.h"

class QDockWidget;
class QToolBar;

namespace tactooth {

/// Where the panels are in the window: tool bars, docks around the picture, and the sizes that they need.
class DockLayout final : public QObject {
    Q_OBJECT

public:
    /// Gives the panels to `window`.
    DockLayout(QMainWindow& window, const WindowPanels& panels);

    [[nodiscard]] QToolBar& fileBar() const { return *fileBar_; }
    [[nodiscard]] QToolBar& viewBar() const { return *viewBar_; }
    /// Fits the docks to the font of their panels. The lowest dock takes the height that is left; the others need no
    /// more than their contents. The gauges are always visible as a whole.
    void fit();
    /// The same as soon as the panels have taken over the font.
    void fitLater();

    void restore(const WindowSettings& settings);
    void store(WindowSettings& settings) const;

private:
    void addToolBars();
    void addDocks();
    void addBusyBar();
    QDockWidget* addDock(QWidget& panel, const char* name, const QString& title, Qt::DockWidgetArea area);
    [[nodiscard]] int tabHeight() const;

    QMainWindow& window_;
    WindowPanels panels_;
    QToolBar* fileBar_;
    QToolBar* viewBar_;
};

}  // namespace tactooth
