// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The window's eye: views, looking inside, colours and language.
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QToolBar>
#include <algorithm>

#include "app/common/inspection.h"
#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/panels/plot_panel.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/window_setup.h"

namespace tactooth {

QAction* MainWindow::addViewAction(const QString& text, const QString& keys, void (ToothView::*act)()) {
    QAction* action = viewMenu_->addAction(text, view_, act);
    action->setShortcut(QKeySequence(keys));
    viewBar_->addAction(action);
    return action;
}

void MainWindow::addViewMenu() {
    viewMenu_ = menuBar()->addMenu(tr("&View"));
    addViewAction(tr("Dentist's view"), "0", &ToothView::resetView);
    const std::array<std::pair<QString, StandardView>, 5> views = {{{tr("Occlusal"), StandardView::Occlusal},
                                                                    {tr("Buccal"), StandardView::Buccal},
                                                                    {tr("Lingual"), StandardView::Lingual},
                                                                    {tr("Mesial"), StandardView::Mesial},
                                                                    {tr("Distal"), StandardView::Distal}}};
    int key = 1;
    QStringList titles;
    for (const auto& [name, view] : views) {
        titles.append(name);
        QAction* action = viewMenu_->addAction(name, this, [this, view = view] { view_->setView(view); });
        action->setShortcut(QKeySequence(QString::number(key++)));
        viewBar_->addAction(action);
    }
    addViewAction(tr("Fit"), "F", &ToothView::fit);
    addSecondViewMenu(titles);
    viewMenu_->addSeparator();
    viewBar_->addSeparator();
    const auto addSwitch = [this](const QString& text, const QString& keys, void (ToothView::*set)(bool)) {
        QAction* action = viewMenu_->addAction(text);
        action->setCheckable(true);
        action->setChecked(true);
        action->setShortcut(QKeySequence(keys));
        connect(action, &QAction::toggled, view_, set);
        viewBar_->addAction(action);
        return action;
    };
    mirrorSwitch_ = addSwitch(tr("Mirror"), "M", &ToothView::setShowsMirror);
    turbineSwitch_ = addSwitch(tr("Turbine"), "H", &ToothView::setShowsTurbine);
    addMirrorMenu();
    viewMenu_->addAction(inspectionPanel_->ghostAction());
    viewMenu_->addSeparator();
    addAppearanceMenu();
    for (QDockWidget* dock : findChildren<QDockWidget*>()) viewMenu_->addAction(dock->toggleViewAction());
}

/// `titles`: of the standard views, in their order.
void MainWindow::addSecondViewMenu(const QStringList& titles) {
    QMenu* menu = viewMenu_->addMenu(tr("&Second view"));
    menu->setObjectName("secondView");
    secondViews_ = new QActionGroup(menu);
    const auto add = [&](const QString& title, int key, std::string_view name) {
        QAction* action = menu->addAction(title);
        action->setCheckable(true);
        action->setShortcut(QKeySequence(QString("Ctrl+%1").arg(key)));
        action->setData(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
        secondViews_->addAction(action);
        return action;
    };
    add(tr("None"), 0, "none")->setChecked(true);
    for (int i = 0; i < titles.size(); ++i) add(titles[i], i + 1, kStandardViews[static_cast<std::size_t>(i)].first);
    connect(secondViews_, &QActionGroup::triggered, this,
            [this](QAction* chosen) { setSecondView(chosen->data().toString()); });
}

/// A name that is none of a view means no second view.
void MainWindow::setSecondView(const QString& name) {
    const QList<QAction*> actions = secondViews_->actions();
    const auto found = std::find_if(actions.begin() + 1, actions.end(), [&](QAction* a) { return a->data() == name; });
    const auto place = found == actions.end() ? 0 : found - actions.begin();
    actions[place]->setChecked(true);
    if (place == 0) return view_->setSecondView({});
    view_->setSecondView(kStandardViews[static_cast<std::size_t>(place - 1)].second, actions[place]->text());
}

void MainWindow::addAppearanceMenu() {
    darkSwitch_ = viewMenu_->addAction(tr("&Dark colours"));
    darkSwitch_->setCheckable(true);
    darkSwitch_->setShortcut(QKeySequence("Ctrl+D"));
    connect(darkSwitch_, &QAction::toggled, this, &MainWindow::setDark);
    addTextSizeMenu();
    addLanguageMenu();
    viewMenu_->addSeparator();
}

void MainWindow::addTextSizeMenu() {
    QMenu* menu = viewMenu_->addMenu(tr("Te&xt size"));
    menu->setObjectName("textSize");
    textSizes_ = new QActionGroup(menu);
    for (const int percent : {100, 125, 150, 200}) {
        QAction* action = menu->addAction(tr("%1 %").arg(percent));
        action->setCheckable(true);
        action->setData(percent / 100.0);
        textSizes_->addAction(action);
    }
    textSizes_->actions().front()->setChecked(true);
    connect(textSizes_, &QActionGroup::triggered, this,
            [this](QAction* chosen) { setTextScale(chosen->data().toDouble()); });
}

void MainWindow::setTextScale(double scale) {
    textScale_ = std::clamp(scale, kMinTextScale, kMaxTextScale);
    for (QAction* action : textSizes_->actions()) action->setChecked(action->data().toDouble() == textScale_);
    applyTextScale(textScale_);
    fitPanels();
}

void MainWindow::setDark(bool dark) {
    applyColours(dark);
    plots_->setColours();
}

/// Languages by their own names, which are the same in every language.
void MainWindow::addLanguageMenu() {
    QMenu* menu = viewMenu_->addMenu(tr("&Language"));
    menu->setObjectName("language");
    languages_ = new QActionGroup(menu);
    const std::pair<QString, const char*> languages[] = {
        {tr("As the system"), ""}, {"English", "en"}, {QStringLiteral("\u65e5\u672c\u8a9e"), "ja"}};
    for (const auto& [name, code] : languages) {
        QAction* action = menu->addAction(name);
        action->setCheckable(true);
        action->setData(code);
        languages_->addAction(action);
    }
    setLanguage({});
    connect(languages_, &QActionGroup::triggered, this, [this](QAction* chosen) {
        const QString code = chosen->data().toString();
        if (code != std::exchange(language_, code)) emit languageChosen();
    });
}

void MainWindow::setLanguage(const QString& code) {
    language_ = code;
    for (QAction* action : languages_->actions()) action->setChecked(action->data().toString() == code);
}

void MainWindow::connectInspection() {
    connect(inspectionPanel_, &InspectionPanel::changed, this, &MainWindow::updateInspection);
    connect(inspectionPanel_->ghostAction(), &QAction::toggled, this, [this](bool on) {
        if (!on) return showUsualHint();
        status_->setHint(tr("Blue glass: still to cut, darker where deeper. Dark line: the outline."));
    });
    connect(tour_, &GuidedTour::says, status_, &StatusLine::setHint);
    connect(tour_, &GuidedTour::ended, this, &MainWindow::showUsualHint);
}

void MainWindow::updateInspection() {
    if (!model_.tooth()) return;
    view_->setInspection(
        inspectionPanel_->inspection(model_.tooth()->box(), model_.mesialX(), model_.materials().registry()),
        inspectionPanel_->stereo());
}

void MainWindow::showDemonstration() { tour_->start(); }

}  // namespace tactooth
