// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/force_panel.h"

#include <QPushButton>

#include "app/gui/hand_control.h"

namespace tactooth {

ForcePanel::ForcePanel(QWidget* parent) : QWidget(parent), fromMaterial_(new QCheckBox(tr("From the material"))) {
    auto* grid = new QGridLayout(this);
    const ForceSettings usual;
    fromMaterial_->setObjectName("fromMaterial");
    fromMaterial_->setToolTip(
        tr("Spring and damper are those of the tissue under the bur:\nenamel is hard, dentin "
           "softer, caries soft. Switch off to set them yourself."));
    grid->addWidget(fromMaterial_, 0, 0, 1, 3);
    spring_ = new NumberRow(*grid, tr("Spring"), {0, kMostSpring, 0.05, 2, tr(" N/mm")}, usual.spring,
                            tr("How hard the tooth feels: force for each millimetre pressed in"));
    damper_ = new NumberRow(*grid, tr("Damper"), {0, kMostDamper, 0.0005, 4, tr(" N·s/mm")}, usual.damper,
                            tr("Force against moving into the tooth, for each mm/s"));
    scale_ = new NumberRow(*grid, tr("Force scale"), {0, kMostForceScale, 0.05, 2, tr(" ×")}, 1,
                           tr("Multiplies the whole force"));
    press_ = new NumberRow(*grid, tr("Mouse presses"), {0, HandControl::kMostPressDepth, 0.1, 1, tr(" mm")}, 1,
                           tr("How deep the mouse hand presses beyond the surface.\nThe mouse wheel in the picture "
                              "changes it too."));
    press_->box().setObjectName("pressDepth");
    auto* defaults = new QPushButton(tr("Defaults"));
    grid->addWidget(defaults, grid->rowCount(), 2);
    grid->setRowStretch(grid->rowCount(), 1);
    connect(fromMaterial_, &QCheckBox::toggled, this, [this](bool on) {
        spring_->setEnabled(!on);
        damper_->setEnabled(!on);
        emit changed();
    });
    for (NumberRow* row : {spring_, damper_, scale_}) connect(row, &NumberRow::changed, this, &ForcePanel::changed);
    connect(press_, &NumberRow::changed, this, &ForcePanel::pressDepthChanged);
    connect(defaults, &QPushButton::clicked, this, [this] { set({}); });
    fromMaterial_->setChecked(true);
}

ForceOverrides ForcePanel::overrides() const {
    if (fromMaterial_->isChecked()) return {};
    return {.stiffness = spring_->value(), .damping = damper_->value(), .friction = std::nullopt};
}

ForceSettings ForcePanel::settings() const {
    return {fromMaterial_->isChecked(), spring_->value(), damper_->value(), scale_->value(), press_->value()};
}

void ForcePanel::set(const ForceSettings& settings) {
    fromMaterial_->setChecked(settings.fromMaterial);
    spring_->setValue(settings.spring);
    damper_->setValue(settings.damper);
    scale_->setValue(settings.scale);
    press_->setValue(settings.press);
}

}  // namespace tactooth
