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
    add(*measures, tr("&Distance"), KeyId::Distance, "distance", MeasureKind::Distance,
        tr("Two clicks: the straight distance between two places, in mm"));
    add(*measures, tr("&Angle between walls"), KeyId::Angle, "angle", MeasureKind::Angle,
        tr("Two clicks: the angle between the normals of the surface at two places, in degrees"));
    add(*measures, tr("&Taper of walls"), KeyId::Taper, "taper", MeasureKind::Taper,
        tr("Two clicks on opposite walls: how far both lean from the direction of insertion, together, in degrees"));
    add(*measures, tr("&Remaining dentin"), KeyId::RemainingDentin, "remaining-dentin", MeasureKind::RemainingDentin,
        tr("One click: the straight distance from a place to the pulp, in mm"));
    clear_ = measures->addAction(tr("&Clear, and end"), &tool_, &MeasureTool::clear);
    clear_->setObjectName("clearMeasure");
    clear_->setShortcut(QKeySequence(Qt::Key_Escape));
    setLineIcon(*clear_, "clear");
    connect(&tool_, &MeasureTool::changed, this, &MeasureMenu::showState);
    showState();
}

void MeasureMenu::add(QMenu& menu, const QString& text, KeyId key, const char* name, MeasureKind kind,
                      const QString& tip) {
    QAction* action = addSwitch(menu, text, key, name);
    setLineIcon(*action, name);
    action->setToolTip(tip);
    action->setStatusTip(tip);
    connect(action, &QAction::triggered, this, [this, kind](bool on) {
        tool_.setKind(on ? std::optional(kind) : std::nullopt);
        if (on) view_.setFocus();  // the arrow keys and Enter mark places
    });
    kinds_[kind] = action;
}

void MeasureMenu::showState() {
    for (const auto& [kind, action] : kinds_) {
        action->setChecked(tool_.kind() == kind);
        action->setEnabled(tool_.isAllowed());
    }
    clear_->setEnabled(tool_.isOn());
}

}  // namespace tactooth
