// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/dock_layout.h"

#include <QApplication>
#include <QDockWidget>
#include <QLayout>
#include <QProgressBar>
#include <QScreen>
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
#include "app/gui/panels/instrument_tray.h"
#include "app/gui/panels/plot_panel.h"
#include "app/gui/panels/sound_panel.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/panels/timing_panel.h"
#include "app/gui/scene/tooth_view.h"

namespace tactooth {
namespace {

constexpr int kLayout = 6;  // version of the set of docks: a saved state of another version is not restored

constexpr const char* kInColumn = "inColumn";  // of the scroll area of a panel whose width fitWidths() sets

/// Makes all of a panel reachable with large text on a small screen. `sideways`: it takes any width.
QScrollArea* scrolling(QWidget& panel, bool sideways) {
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);  // the Tab key stops at its controls, not at the area
    area->setProperty(kInColumn, !sideways);
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
    setUsualSizes();
    firstState_ = window_.saveState(kLayout);
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
    window_.addToolBar(Qt::LeftToolBarArea, panels_.tray);
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
    drill_ = addDock(*panels_.drive, "Drill", tr("Drill"), Qt::RightDockWidgetArea);
    force_ = addDock(*panels_.force, "Force", tr("Force"), Qt::RightDockWidgetArea);
    QDockWidget* hand = addDock(*panels_.device, "Hand", tr("Hand"), Qt::RightDockWidgetArea);
    QDockWidget* sound = addDock(*panels_.sound, "Sound", tr("Sound"), Qt::RightDockWidgetArea);
    // The user sets these rarely. One below the other they are higher than most screens.
    window_.tabifyDockWidget(force_, hand);
    window_.tabifyDockWidget(hand, sound);
    force_->raise();
    inside_ = addDock(*panels_.inspection, "Look inside", tr("Look inside"), Qt::RightDockWidgetArea);
    QDockWidget* plots = addDock(*panels_.plots, "Last ten seconds", tr("Last ten seconds"), Qt::BottomDockWidgetArea);
    window_.tabifyDockWidget(plots, addDock(*panels_.exercise, "Exercise", tr("Exercise"), Qt::BottomDockWidgetArea));
    window_.tabifyDockWidget(plots,
                             addDock(*panels_.events, "What happened", tr("What happened"), Qt::BottomDockWidgetArea));
    window_.tabifyDockWidget(plots, addDock(*panels_.history, "History", tr("History"), Qt::BottomDockWidgetArea));
    window_.tabifyDockWidget(plots, addDock(*panels_.timing, "Real time", tr("Real time"), Qt::BottomDockWidgetArea));
    plots->raise();
}

/// On a small screen the window takes what is free there.
void DockLayout::setUsualSizes() {
    window_.resize(QSize(1400, 900).boundedTo(window_.screen()->availableSize()));
    fit();
    // The first tab is visible as a whole; the tabs behind it may scroll.
    window_.resizeDocks({drill_, force_, inside_},
                        {panels_.drive->sizeHint().height(), panels_.force->sizeHint().height(),
                         panels_.inspection->sizeHint().height()},
                        Qt::Vertical);
}

void DockLayout::reset() {
    if (window_.isMaximized() || window_.isFullScreen()) window_.showNormal();
    widthBefore_.reset();
    forcedWidth_ = 0;
    window_.restoreState(firstState_, kLayout);
    setUsualSizes();
    fitLater();
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
        if (!area->property(kInColumn).toBool()) continue;
        QWidget& panel = *area->widget();
        panel.ensurePolished();
        panel.layout()->invalidate();  // its size is that of the font before
        fitHeight(*area, panel);
    }
    fitWidths();
    QFont title = QApplication::font();
    title.setStyleStrategy(QFont::PreferAntialias);  // with the default font a dock's title would keep its size
    for (auto* dock : window_.findChildren<QDockWidget*>()) dock->setFont(title);
}

void DockLayout::fitHeight(QScrollArea& area, QWidget& panel) const {
    if (&panel == panels_.inspection) return;
    area.setMaximumHeight(&panel == panels_.drive ? panel.sizeHint().height() : tabHeight());
    if (&panel == panels_.drive) area.setMinimumHeight(panel.sizeHint().height());
}

void DockLayout::fitWidths() {
    constexpr double kMost = 0.33;  // of the window
    constexpr int kLeast = 360;     // pixels: all panels at the usual size of the text
    const int most = std::max(kLeast, static_cast<int>(kMost * window_.width()));
    int wanted = 0;
    for (auto* area : window_.findChildren<QScrollArea*>()) {
        if (!area->property(kInColumn).toBool()) continue;
        const int needed =
            area->widget()->minimumSizeHint().width() + window_.style()->pixelMetric(QStyle::PM_ScrollBarExtent);
        area->setHorizontalScrollBarPolicy(needed > most ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
        area->setMinimumWidth(std::min(needed, most));
        wanted = std::max(wanted, area->minimumWidth());
    }
    resizeColumn(wanted);
}

/// `wanted`: the least width now. The user's own width comes back after large text.
void DockLayout::resizeColumn(int wanted) {
    if (!drill_->isVisible() || drill_->isFloating()) return;
    const int now = drill_->width();
    if (wanted > now) {
        if (!widthBefore_) widthBefore_ = now;
        forcedWidth_ = wanted;
        return;
    }
    if (!widthBefore_ || wanted >= forcedWidth_) return;
    constexpr int kSame = 4;                          // pixels
    const bool isOurs = now <= forcedWidth_ + kSame;  // the user has not made it wider meanwhile
    if (isOurs) window_.resizeDocks({drill_}, {std::max(wanted, *widthBefore_)}, Qt::Horizontal);
    forcedWidth_ = wanted;
    if (!isOurs || wanted <= *widthBefore_) widthBefore_.reset();
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
