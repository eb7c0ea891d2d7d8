// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/dock_layout.h"

#include <QApplication>
#include <QDockWidget>
#include <QLayout>
#include <QProgressBar>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStyle>
#include <QTimer>
#include <QToolBar>
#include <algorithm>

#include "app/gui/panels/device_panel.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "app/gui/panels/event_panel.h"
#include "app/gui/panels/exercise_panel.h"
#include "app/gui/panels/force_panel.h"
#include "app/gui/panels/history_panel.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/panels/plot_panel.h"
#include "app/gui/panels/sound_panel.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/panels/timing_panel.h"
#include "app/gui/scene/tooth_view.h"

namespace tactooth {
namespace {

constexpr int kLayout = 5;  // version of the set of docks: a saved state of another version is not restored

/// Makes all of a panel reachable with large text on a small screen. `sideways`: it scrolls horizontally too; otherwise
/// the area takes the width that the panel needs.
QScrollArea* scrolling(QWidget& panel, bool sideways) {
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);  // the Tab key stops at its controls, not at the area
    area->setHorizontalScrollBarPolicy(sideways ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
    area->setWidget(&panel);
    return area;
}

QByteArray unpacked(const std::string& text) { return QByteArray::fromBase64(QByteArray::fromStdString(text)); }

}  // namespace

DockLayout::DockLayout(QMainWindow& window, const WindowPanels& panels)
    : window_(window), panels_(panels), fileBar_(window.addToolBar(tr("File"))), viewBar_(new QToolBar(tr("View"))) {
    auto* middle = new QStackedWidget;  // other views may take its place
    middle->addWidget(panels_.view);
    window_.setCentralWidget(middle);
    window_.setStatusBar(panels_.status);
    addToolBars();
    addDocks();
    addBusyBar();
}

void DockLayout::addToolBars() {
    fileBar_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    fileBar_->setObjectName("fileBar");
    panels_.drill->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    viewBar_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    viewBar_->setObjectName("viewBar");
    window_.addToolBar(viewBar_);
    window_.addToolBarBreak();
    window_.addToolBar(panels_.drill);
}

/// `name`: by which a saved layout knows it, in every language.
QDockWidget* DockLayout::addDock(QWidget& panel, const char* name, const QString& title, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title);
    dock->setObjectName(name);
    // These take any size.
    const bool scrolls = &panel != panels_.plots && &panel != panels_.events && &panel != panels_.history;
    dock->setWidget(scrolls ? scrolling(panel, area != Qt::RightDockWidgetArea) : &panel);
    window_.addDockWidget(area, dock);
    return dock;
}

void DockLayout::addDocks() {
    window_.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    QDockWidget* drill = addDock(*panels_.drive, "Drill", tr("Drill"), Qt::RightDockWidgetArea);
    QDockWidget* force = addDock(*panels_.force, "Force", tr("Force"), Qt::RightDockWidgetArea);
    QDockWidget* hand = addDock(*panels_.device, "Hand", tr("Hand"), Qt::RightDockWidgetArea);
    QDockWidget* sound = addDock(*panels_.sound, "Sound", tr("Sound"), Qt::RightDockWidgetArea);
    // The user sets these rarely. One below the other they are higher than most screens.
    window_.tabifyDockWidget(force, hand);
    window_.tabifyDockWidget(hand, sound);
    force->raise();
    QDockWidget* inside = addDock(*panels_.inspection, "Look inside", tr("Look inside"), Qt::RightDockWidgetArea);
    QDockWidget* plots = addDock(*panels_.plots, "Last ten seconds", tr("Last ten seconds"), Qt::BottomDockWidgetArea);
    window_.tabifyDockWidget(plots, addDock(*panels_.exercise, "Exercise", tr("Exercise"), Qt::BottomDockWidgetArea));
    window_.tabifyDockWidget(plots,
                             addDock(*panels_.events, "What happened", tr("What happened"), Qt::BottomDockWidgetArea));
    window_.tabifyDockWidget(plots, addDock(*panels_.history, "History", tr("History"), Qt::BottomDockWidgetArea));
    window_.tabifyDockWidget(plots, addDock(*panels_.timing, "Real time", tr("Real time"), Qt::BottomDockWidgetArea));
    plots->raise();
    fit();
    // The first tab is visible as a whole; the tabs behind it may scroll.
    window_.resizeDocks({drill, force, inside},
                        {panels_.drive->sizeHint().height(), panels_.force->sizeHint().height(),
                         panels_.inspection->sizeHint().height()},
                        Qt::Vertical);
}

void DockLayout::addBusyBar() {
    panels_.busy->setRange(0, 0);
    panels_.busy->setMaximumWidth(120);
    panels_.busy->setObjectName("busy");
    panels_.status->addPermanentWidget(panels_.busy);
}

/// Of the highest panel among the tabs on the right.
int DockLayout::tabHeight() const {
    return std::max(
        {panels_.force->sizeHint().height(), panels_.device->sizeHint().height(), panels_.sound->sizeHint().height()});
}

void DockLayout::fit() {
    for (auto* area : window_.findChildren<QScrollArea*>()) {
        QWidget& panel = *area->widget();
        if (area->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) continue;
        panel.ensurePolished();
        panel.layout()->invalidate();  // its size is that of the font before
        area->setMinimumWidth(panel.minimumSizeHint().width() +
                              window_.style()->pixelMetric(QStyle::PM_ScrollBarExtent));
        if (&panel == panels_.inspection) continue;
        area->setMaximumHeight(&panel == panels_.drive ? panel.sizeHint().height() : tabHeight());
        if (&panel == panels_.drive) area->setMinimumHeight(panel.sizeHint().height());
    }
    QFont title = QApplication::font();
    title.setStyleStrategy(QFont::PreferAntialias);  // with the default font a dock's title would keep its size
    for (auto* dock : window_.findChildren<QDockWidget*>()) dock->setFont(title);
}

void DockLayout::fitLater() { QTimer::singleShot(0, this, &DockLayout::fit); }

void DockLayout::restore(const WindowSettings& settings) {
    window_.restoreGeometry(unpacked(settings.geometry));
    window_.restoreState(unpacked(settings.docks), kLayout);
}

void DockLayout::store(WindowSettings& settings) const {
    settings.geometry = window_.saveGeometry().toBase64().toStdString();
    settings.docks = window_.saveState(kLayout).toBase64().toStdString();
}

}  // namespace tactooth
