// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/view_aids_menu.h"

#include "app/gui/icons/line_icon.h"
#include "app/gui/menus/menu_switch.h"
#include "app/gui/scene/tooth_view.h"

namespace tactooth {

ViewAidsMenu::ViewAidsMenu(QMenu& menu, ToothView& view) : view_(view) {
    QMenu* aids = menu.addMenu(tr("&Aids"));
    aids->setObjectName("viewAids");
    aids->setToolTipsVisible(true);
    setLineIcon(*aids->menuAction(), "panel");
    glass_ = add(*aids, tr("&Glass handpiece"), KeyId::Glass, "glass", "glass",
                 tr("Handles and the shank turn to glass where they hide the bur's head or the place where it lands"));
    magnifier_ = add(*aids, tr("&Magnifier"), KeyId::Magnifier, "magnifier", "magnifier",
                     tr("The bur's head, four times as large, in the upper left corner"));
    scaleBar_ = add(*aids, tr("&Scale bar"), KeyId::ScaleBar, "scaleBar", "scale-bar",
                    tr("Length in mm at the depth of the tooth"));
    letters_ = add(*aids, tr("&Letters of the directions"), KeyId::Letters, "axisLetters", "letters",
                   tr("B buccal, L lingual, M mesial, D distal, O occlusal, A apical"));
    cube_ = add(*aids, tr("View &cube"), KeyId::Cube, "viewCubeSwitch", "cube",
                tr("Shows the side of the view; a click on a face changes to that side"));
    softTissues_ = add(*aids, tr("Cheeks, lips and &tongue"), KeyId::SoftTissues, "softTissues", "soft-tissues",
                       tr("What surrounds the jaws of the whole mouth. It is left out where it would hide the tooth"));
    restore({});
}

QAction* ViewAidsMenu::add(QMenu& menu, const QString& text, KeyId key, const char* name, const char* icon,
                           const QString& tip) {
    QAction* action = addSwitch(menu, text, key, name);
    setLineIcon(*action, icon);
    action->setToolTip(tip);
    action->setStatusTip(tip);
    connect(action, &QAction::toggled, this, &ViewAidsMenu::show);
    return action;
}

ViewAids ViewAidsMenu::aids() const {
    return {.glass = glass_->isChecked(),
            .scaleBar = scaleBar_->isChecked(),
            .letters = letters_->isChecked(),
            .cube = cube_->isChecked(),
            .magnifier = magnifier_->isChecked(),
            .softTissues = softTissues_->isChecked()};
}

void ViewAidsMenu::show() { view_.setAids(aids()); }

void ViewAidsMenu::restore(const WindowSettings& settings) {
    const ViewAids& wanted = settings.aids;
    glass_->setChecked(wanted.glass);
    scaleBar_->setChecked(wanted.scaleBar);
    letters_->setChecked(wanted.letters);
    cube_->setChecked(wanted.cube);
    magnifier_->setChecked(wanted.magnifier);
    softTissues_->setChecked(wanted.softTissues);
    show();
}

void ViewAidsMenu::store(WindowSettings& settings) const { settings.aids = aids(); }

}  // namespace tactooth
