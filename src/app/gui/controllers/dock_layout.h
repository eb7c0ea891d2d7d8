// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <optional>

#include "app/gui/controllers/window_panels.h"
#include "app/gui/settings/window_settings.h"

class QDockWidget;
class QScrollArea;
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
    /// more than their contents. The gauges are always visible as a whole. No panel takes more than a third of the
    /// window's width: where its text is larger, it scrolls. When the text gets smaller again, so do the docks.
    void fit();
    /// The same as soon as the panels have taken over the font.
    void fitLater();

    /// Docks, tool bars and size of the window as at the first start.
    void reset();
    void restore(const WindowSettings& settings);
    void store(WindowSettings& settings) const;

private:
    void addToolBars();
    void addDocks();
    void addBusyBar();
    void setUsualSizes();
    QDockWidget* addDock(QWidget& panel, const char* name, const QString& title, Qt::DockWidgetArea area);
    [[nodiscard]] int tabHeight() const;
    void fitHeight(QScrollArea& area, QWidget& panel) const;
    void fitWidths();
    void resizeColumn(int wanted);

    QMainWindow& window_;
    WindowPanels panels_;
    QToolBar* fileBar_;
    QToolBar* viewBar_;
    QDockWidget* drill_ = nullptr;  // stands for its column
    QDockWidget* force_ = nullptr;
    QDockWidget* inside_ = nullptr;
    QByteArray firstState_;           // of docks and tool bars
    std::optional<int> widthBefore_;  // of that column, before large text made it wider; pixels
    int forcedWidth_ = 0;             // what large text made of it
};

}  // namespace tactooth
