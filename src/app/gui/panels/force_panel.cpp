// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/force_panel.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <utility>

#include "app/gui/text/translation.h"
#include "session/model/session_model.h"

namespace tactooth {

ForcePanel::ForcePanel(QWidget* parent)
    : QWidget(parent), fromMaterial_(new QCheckBox(tr("From the material"))), presets_(new QComboBox) {
    auto* grid = new QGridLayout(this);
    const ForceSettings usual;
    fromMaterial_->setObjectName("fromMaterial");
    fromMaterial_->setToolTip(
        tr("Spring, damper and friction are those of the tissue under the bur:\nenamel is hard, dentin "
           "softer, caries soft. Switch off to set them yourself."));
    addPresets(*grid);
    spring_ = new NumberRow(*grid, tr("Spring"), {0, kMaxSpring, 0.05, 2, tr(" N/mm")}, usual.spring,
                            tr("How hard the tooth feels: force for each millimetre pressed in"));
    damper_ = new NumberRow(*grid, tr("Damper"), {0, kMaxDamper, 0.0005, 4, tr(" N·s/mm")}, usual.damper,
                            tr("Force against moving into the tooth, for each mm/s"));
    friction_ = new NumberRow(*grid, tr("Friction"), {0, kMaxFriction, 0.01, 2, QString()}, usual.friction,
                              tr("Force against sliding, as a share of the force into the tooth"));
    friction_->box().setObjectName("friction");
    spring_->box().setObjectName("spring");
    scale_ = new NumberRow(*grid, tr("Force scale"), {0, kMaxForceScale, 0.05, 2, tr(" ×")}, 1,
                           tr("Multiplies the whole force"));
    addHand(*grid);
    auto* defaults = new QPushButton(tr("Defaults"));
    grid->addWidget(defaults, grid->rowCount(), 2);
    grid->setRowStretch(grid->rowCount(), 1);
    connect(fromMaterial_, &QCheckBox::toggled, this, [this](bool on) {
        spring_->setEnabled(!on);
        damper_->setEnabled(!on);
        friction_->setEnabled(!on);
        emit changed();
    });
    for (NumberRow* row : {spring_, damper_, friction_, scale_})
        connect(row, &NumberRow::changed, this, &ForcePanel::changed);
    connect(defaults, &QPushButton::clicked, this, [this] { set({}); });
    fromMaterial_->setChecked(true);
}

/// Where the hand stops: the mouse at a depth, or never, for as long as the button is down; a device at that depth.
void ForcePanel::addHand(QGridLayout& grid) {
    const ForceSettings usual;
    mouse_ = new QComboBox;
    mouse_->setObjectName("mouseMode");
    mouse_->addItem(tr("Mouse cuts to a depth"), QString(kMouseToDepth));
    mouse_->addItem(tr("Mouse presses by force"), QString(kMouseByForce));
    mouse_->setAccessibleName(tr("How the mouse presses"));
    mouse_->setToolTip(tr(
        "To a depth: the bur stops at the depth that is set here.\nBy force: the bur sinks for as long as the button "
        "is down."));
    grid.addWidget(mouse_, grid.rowCount(), 0, 1, 3);
    depth_ =
        new NumberRow(grid, tr("Depth"), {0, DepthControl::kMaxDepth, 0.1, 2, tr(" mm")}, usual.depth,
                      tr("Depth of the tip below the uncut surface at which the bur stops.\nThe mouse wheel in the "
                         "picture changes it by 0.1 mm, with Shift by 0.02 mm."));
    depth_->box().setObjectName("mouseDepth");
    flat_ = new QCheckBox(tr("Flat floor"));
    flat_->setObjectName("flatFloor");
    flat_->setToolTip(
        tr("On: the depth counts from the place where the cavity was begun, and the floor is flat.\nOff: the floor "
           "follows the surface."));
    stop_ = new QCheckBox(tr("Device stops there"));
    stop_->setObjectName("depthStop");
    stop_->setToolTip(
        tr("A device that renders force holds the bur at the depth and pushes the hand back.\nIt is off in an "
           "examination."));
    guide_ = new QCheckBox(tr("Guide"));
    guide_->setObjectName("wallGuide");
    guide_->setToolTip(
        tr("A device that renders force gently pushes the hand back where the bur goes beyond the walls of the "
           "target.\nIt can be overcome, and is off in an examination."));
    auto* switches = new QHBoxLayout;  // in one row: the panel is as high as the window at its first start
    switches->addWidget(flat_);
    switches->addWidget(stop_);
    switches->addWidget(guide_);
    switches->addStretch();
    grid.addLayout(switches, grid.rowCount(), 0, 1, 3);
    press_ =
        new NumberRow(grid, tr("Mouse presses"), {0, MouseManipulator::kMaxPressDepth, 0.1, 1, tr(" mm")}, usual.press,
                      tr("How far the mouse presses beyond the surface: 1 mm is about 1 N on enamel."));
    press_->box().setObjectName("pressDepth");
    const auto enableDepth = [this] {
        const bool usesDepth = settings().mouse == kMouseToDepth || stop_->isChecked();
        depth_->setEnabled(usesDepth);
        flat_->setEnabled(usesDepth);
        emit handChanged();
    };
    connect(mouse_, &QComboBox::currentIndexChanged, this, enableDepth);
    connect(stop_, &QCheckBox::toggled, this, enableDepth);
    connect(stop_, &QCheckBox::clicked, this, [this] { chosenStop_.reset(); });
    connect(depth_, &NumberRow::changed, this, &ForcePanel::handChanged);
    connect(flat_, &QCheckBox::toggled, this, &ForcePanel::handChanged);
    connect(guide_, &QCheckBox::toggled, this, &ForcePanel::handChanged);
    connect(press_, &NumberRow::changed, this, &ForcePanel::handChanged);
}

void ForcePanel::applyTo(SessionModel& model) const {
    const ForceSettings now = settings();
    model.aids().setDepthStop(stop_->isChecked());
    model.aids().setGuide(now.guide);
    MouseManipulator& hand = model.manipulator();
    hand.setPressMode(now.mouse == kMouseByForce ? PressMode::Force : PressMode::Depth);
    hand.setPressDepth(now.press);
    hand.depthControl().setDepth(now.depth);
    hand.depthControl().setFloor(now.flatFloor ? CavityFloor::Flat : CavityFloor::FollowsSurface);
}

void ForcePanel::wantDepthStop(bool wanted) {
    if (wanted) {
        chosenStop_ = chosenStop_.value_or(stop_->isChecked());
        stop_->setChecked(true);
    } else if (chosenStop_) {
        stop_->setChecked(*std::exchange(chosenStop_, std::nullopt));
    }
}

ForceOverrides ForcePanel::overrides() const {
    if (fromMaterial_->isChecked()) return {};
    return {.stiffness = spring_->value(), .damping = damper_->value(), .friction = friction_->value()};
}

ForceSettings ForcePanel::settings() const {
    return {.fromMaterial = fromMaterial_->isChecked(),
            .spring = spring_->value(),
            .damper = damper_->value(),
            .scale = scale_->value(),
            .press = press_->value(),
            .mouse = mouse_->currentData().toString().toStdString(),
            .depth = depth_->value(),
            .flatFloor = flat_->isChecked(),
            .depthStop = chosenStop_.value_or(stop_->isChecked()),
            .guide = guide_->isChecked(),
            .friction = friction_->value()};
}

void ForcePanel::set(const ForceSettings& settings) {
    fromMaterial_->setChecked(settings.fromMaterial);
    spring_->setValue(settings.spring);
    damper_->setValue(settings.damper);
    scale_->setValue(settings.scale);
    press_->setValue(settings.press);
    mouse_->setCurrentIndex(settings.mouse == kMouseByForce ? 1 : 0);
    depth_->setValue(settings.depth);
    flat_->setChecked(settings.flatFloor);
    if (chosenStop_) {
        chosenStop_ = settings.depthStop;  // the exercise still wants it
    } else {
        stop_->setChecked(settings.depthStop);
    }
    guide_->setChecked(settings.guide);
    friction_->setValue(settings.friction);
}

/// The tissues whose parameters the user can choose for the whole tooth.
void ForcePanel::addPresets(QGridLayout& grid) {
    grid.addWidget(fromMaterial_, 0, 0, 1, 2);
    grid.addWidget(presets_, 0, 2);
    presets_->setObjectName("forcePresets");
    presets_->setAccessibleName(tr("Feel like"));
    presets_->setToolTip(tr("Lets the whole tooth feel like one tissue: fills in its spring, damper and friction"));
    setMaterials(MaterialTable());
    connect(presets_, &QComboBox::activated, this, [this](int index) {
        if (index > 0) applyPreset(static_cast<MaterialId>(presets_->itemData(index).toInt()));
        presets_->setCurrentIndex(0);
    });
}

void ForcePanel::setMaterials(const MaterialTable& materials) {
    materials_ = materials;
    presets_->clear();
    presets_->addItem(tr("Feel like…"));
    const MaterialRegistry& registry = materials.registry();
    for (const MaterialId id : registry.inMenuOrder()) {
        if (registry.hasRole(id, MaterialRole::Surroundings)) continue;
        presets_->addItem(materialLabel(registry[id]), static_cast<int>(id));
    }
}

void ForcePanel::applyPreset(MaterialId tissue) {
    const Material& numbers = materials_[tissue];
    fromMaterial_->setChecked(false);
    spring_->setValue(numbers.stiffness);
    damper_->setValue(numbers.damping);
    friction_->setValue(numbers.friction);
}

}  // namespace tactooth
