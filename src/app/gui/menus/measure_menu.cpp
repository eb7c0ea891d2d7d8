// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/measure_menu.h"

#include "app/gui/icons/line_icon.h"
#include "app/gui/menus/menu_switch.h"
#include "app/gui/scene/tooth_view.h"

namespace tactooth {

MeasureMenu::MeasureMenu(QMenu& menu, ToothView& view) : view_(view), tool_(view.measureTool()) {
    QMenu* measures = menu.addMenu(tr("M&easure"));
    measures->setObjectName("measure");
    measures->setToolTipsVisible(true);
    setLineIcon(*measures->menuAction(), "measure");
    distance_ = add(*measures, tr("&Distance"), KeyId::Distance, "distance", MeasureKind::Distance,
                    tr("Two clicks: the straight distance between two places, in mm"));
    angle_ = add(*measures, tr("&Angle between walls"), KeyId::Angle, "angle", MeasureKind::Angle,
                 tr("Two clicks: the angle between the normals of the surface at two places, in degrees"));
    clear_ = measures->addAction(tr("&Clear, and end"), &tool_, &MeasureTool::clear);
    clear_->setObjectName("clearMeasure");
    clear_->setShortcut(QKeySequence(Qt::Key_Escape));
    setLineIcon(*clear_, "clear");
    connect(&tool_, &MeasureTool::changed, this, &MeasureMenu::showState);
    showState();
}

QAction* MeasureMenu::add(QMenu& menu, const QString& text, KeyId key, const char* name, MeasureKind kind,
                          const QString& tip) {
    QAction* action = addSwitch(menu, text, key, name);
    setLineIcon(*action, name);
    action->setToolTip(tip);
    action->setStatusTip(tip);
    connect(action, &QAction::triggered, this, [this, kind](bool on) {
        tool_.setKind(on ? std::optional(kind) : std::nullopt);
        if (on) view_.setFocus();  // the arrow keys and Enter mark places
    });
    return action;
}

void MeasureMenu::showState() {
    distance_->setChecked(tool_.kind() == MeasureKind::Distance);
    angle_->setChecked(tool_.kind() == MeasureKind::Angle);
    for (QAction* action : {distance_, angle_}) action->setEnabled(tool_.isAllowed());
    clear_->setEnabled(tool_.isOn());
}

}  // namespace tactooth
