// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/instrument_menus.h"

#include <QActionGroup>

#include "app/gui/icons/line_icon.h"
#include "app/gui/menus/menu_switch.h"
#include "session/model/instrument_set.h"

namespace tactooth {

void InstrumentMenus::addSpraySwitches(QMenu& menu) {
    water_ = addSwitch(menu, tr("&Water spray"), KeyId::Water, "water");
    suction_ = addSwitch(menu, tr("Su&ction"), KeyId::Suction, "suction");
    setLineIcon(*water_, "water");
    setLineIcon(*suction_, "suction");
    connect(water_, &QAction::toggled, this, [this](bool on) { instruments_.setWater(on); });
    connect(suction_, &QAction::toggled, this, [this](bool on) { instruments_.setSuction(on); });
    water_->setChecked(true);
    suction_->setChecked(false);
}

void InstrumentMenus::addMirrorMenu(QMenu& menu) {
    QMenu* glass = menu.addMenu(tr("Mirror &glass"));
    glass->setObjectName("mirrorGlass");
    setLineIcon(*glass->menuAction(), "glass");
    sizes_ = new QActionGroup(glass);
    for (const MirrorSize& size : kMirrorSizes) {
        QAction* action = glass->addAction(tr("No. %1, %2 mm").arg(QString(size.number)).arg(size.diameter));
        action->setCheckable(true);
        action->setData(size.number);
        sizes_->addAction(action);
    }
    glass->addSeparator();
    fog_ = addSwitch(*glass, tr("&Fogged"), KeyId::Fogged, "fogged");
    drops_ = addSwitch(*glass, tr("&Drops of spray"), KeyId::Drops, "drops");
    setLineIcon(*fog_, "fog");
    setLineIcon(*drops_, "drops");
    dims_ = glass->addAction(tr("Dims by &itself"));
    dims_->setObjectName("mirrorDims");
    dims_->setCheckable(true);
    dims_->setToolTip(
        tr("In the mouth, breath fogs the mirror slowly while no spray runs, and what the bur throws soils it. "
           "Fogged, switched on and off, wipes the glass. An examination leaves it clear."));
    setLineIcon(*dims_, "fog");
    setMirror({});
    connect(sizes_, &QActionGroup::triggered, this, &InstrumentMenus::updateMirror);
    for (QAction* action : {fog_, drops_, dims_})
        connect(action, &QAction::toggled, this, &InstrumentMenus::updateMirror);
}

/// An unknown size keeps the one before.
void InstrumentMenus::setMirror(const MirrorSettings& mirror) {
    for (QAction* action : sizes_->actions()) {
        if (action->data().toString().toStdString() == mirror.number) action->setChecked(true);
    }
    fog_->setChecked(mirror.fogged);
    drops_->setChecked(mirror.wet);
    dims_->setChecked(mirror.dims);
    updateMirror();
}

void InstrumentMenus::updateMirror() {
    const auto size = static_cast<std::size_t>(sizes_->actions().indexOf(sizes_->checkedAction()));
    instruments_.setMirror({kMirrorSizes[size].diameter, fog_->isChecked(), drops_->isChecked(), dims_->isChecked()});
}

void InstrumentMenus::restore(const WindowSettings& settings) {
    setMirror(settings.mirror);
    water_->setChecked(settings.water);
    suction_->setChecked(settings.suction);
}

void InstrumentMenus::store(WindowSettings& settings) const {
    settings.mirror = {sizes_->checkedAction()->data().toString().toStdString(), fog_->isChecked(), drops_->isChecked(),
                       dims_->isChecked()};
    settings.water = water_->isChecked();
    settings.suction = suction_->isChecked();
}

}  // namespace tactooth
