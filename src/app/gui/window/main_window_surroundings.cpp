// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is around the bur: water, suction tube and mouth mirror.
#include <QActionGroup>
#include <QMenu>

#include "app/gui/scene/tooth_view.h"
#include "app/gui/window/main_window.h"

namespace tactooth {
namespace {

QAction* addSwitch(QMenu& menu, const QString& text, const QString& keys, const QString& name) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setShortcut(QKeySequence(keys));
    action->setObjectName(name);
    return action;
}

}  // namespace

void MainWindow::addSpraySwitches(QMenu& menu) {
    waterSwitch_ = addSwitch(menu, tr("&Water spray"), "W", "water");
    suctionSwitch_ = addSwitch(menu, tr("Su&ction"), "S", "suction");
    connect(waterSwitch_, &QAction::toggled, this, [this](bool on) { model_.setWater(on); });
    connect(suctionSwitch_, &QAction::toggled, this, [this](bool on) { model_.setSuction(on); });
    waterSwitch_->setChecked(true);
    suctionSwitch_->setChecked(false);
}

void MainWindow::addMirrorMenu() {
    QMenu* menu = viewMenu_->addMenu(tr("Mirror &glass"));
    menu->setObjectName("mirrorGlass");
    mirrorSizes_ = new QActionGroup(menu);
    for (const MirrorSize& size : kMirrorSizes) {
        QAction* action = menu->addAction(tr("No. %1, %2 mm").arg(QString(size.number)).arg(size.diameter));
        action->setCheckable(true);
        action->setData(size.number);
        mirrorSizes_->addAction(action);
    }
    menu->addSeparator();
    fogSwitch_ = addSwitch(*menu, tr("&Fogged"), "B", "fogged");
    dropsSwitch_ = addSwitch(*menu, tr("&Drops of spray"), "D", "drops");
    setMirror({});
    connect(mirrorSizes_, &QActionGroup::triggered, this, &MainWindow::replaceMirrorFromMenu);
    for (QAction* action : {fogSwitch_, dropsSwitch_}) {
        connect(action, &QAction::toggled, this, &MainWindow::replaceMirrorFromMenu);
    }
}

MirrorSettings MainWindow::mirror() const {
    return {mirrorSizes_->checkedAction()->data().toString().toStdString(), fogSwitch_->isChecked(),
            dropsSwitch_->isChecked()};
}

/// A size that is none leaves the one that was there.
void MainWindow::setMirror(const MirrorSettings& mirror) {
    for (QAction* action : mirrorSizes_->actions()) {
        if (action->data().toString().toStdString() == mirror.number) action->setChecked(true);
    }
    fogSwitch_->setChecked(mirror.fogged);
    dropsSwitch_->setChecked(mirror.wet);
    replaceMirrorFromMenu();
}

void MainWindow::replaceMirrorFromMenu() {
    const int place = static_cast<int>(mirrorSizes_->actions().indexOf(mirrorSizes_->checkedAction()));
    model_.setMirror(kMirrorSizes[static_cast<std::size_t>(place)].diameter, fogSwitch_->isChecked(),
                     dropsSwitch_->isChecked());
}

}  // namespace tactooth
