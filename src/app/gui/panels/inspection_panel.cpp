// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/inspection_panel.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/icons/line_icon.h"
#include "app/gui/keys/key_binding.h"

namespace tactooth {
namespace {

constexpr int kFull = 100;              // percent
constexpr int kFarthest = 60;           // tenths of a mm: half a molar
constexpr double kTenth = 0.1;          // mm
constexpr double kColourRange = 0.5;    // mm; an examiner calls that too deep or too shallow
constexpr double kMostTolerance = 0.4;  // mm; less than the range

QSlider* slider(int low, int high, int value, const QString& tip, const char* name) {
    auto* result = new QSlider(Qt::Horizontal);
    result->setRange(low, high);
    result->setValue(value);
    result->setToolTip(tip);
    result->setObjectName(name);
    return result;
}

}  // namespace

InspectionPanel::InspectionPanel(QWidget* parent)
    : QWidget(parent),
      section_(new QComboBox),
      place_(slider(-kFarthest, kFarthest, 0, tr("Where the section runs: from the far to the near side"),
                    "sectionPlace")),
      follows_(new QCheckBox(tr("At the bur"))),
      enamel_(
          slider(0, kFull, kFull, tr("Look through the enamel at the dentin and the caries in it"), "enamelOpacity")),
      dentin_(slider(0, kFull, kFull, tr("Look through the dentin at the pulp"), "dentinOpacity")),
      stereo_(new QComboBox),
      choose_(new QPushButton(tr("Target…"))),
      coloured_(new QCheckBox(tr("Show distance"))),
      tolerance_(new QDoubleSpinBox),
      ghost_(new QCheckBox(tr("Show what to cut"))),
      showGhost_(new QAction(tr("What to &cut: ghost of the target"), this)) {
    section_->addItem(tr("None"));
    for (const QString& name : {tr("Occlusal"), tr("Buccal"), tr("Lingual"), tr("Mesial"), tr("Distal")}) {
        section_->addItem(name);
    }
    section_->setObjectName("section");
    section_->setToolTip(tr("Takes this side of the tooth out of the picture; the tooth itself stays whole"));
    place_->setAccessibleName(tr("Place"));
    follows_->setObjectName("sectionFollows");
    follows_->setToolTip(
        tr("The section goes with the tip of the bur, so that its floor and walls are seen as they are cut"));
    auto* place = new QHBoxLayout;
    place->addWidget(place_, 1);
    place->addWidget(follows_);
    stereo_->addItems({tr("One eye"), tr("Side by side"), tr("Red and cyan")});
    stereo_->setObjectName("stereo");
    stereo_->setToolTip(tr("Shows depth: side by side for goggles, red and cyan for coloured glasses"));
    coloured_->setEnabled(false);
    coloured_->setObjectName("coloured");
    coloured_->setToolTip(tr("Blue: still to cut. White: as the target. Orange: cut too deep. Strongest at 0.5 mm."));
    tolerance_->setRange(0, kMostTolerance);
    tolerance_->setSingleStep(kTenth / 2);
    tolerance_->setValue(kUsualTolerance);
    tolerance_->setPrefix(QStringLiteral("\u00b1"));
    tolerance_->setSuffix(tr(" mm"));
    tolerance_->setAccessibleName(tr("Tolerance"));
    tolerance_->setObjectName("tolerance");
    tolerance_->setToolTip(tr("Tolerance: a smaller distance to the target is shown white"));
    ghost_->setObjectName("ghost");
    showGhost_->setCheckable(true);
    setLineIcon(*showGhost_, "ghost");
    bindKey(*showGhost_, KeyId::Ghost);
    showGhost_->setObjectName("showGhost");
    setTarget({});
    auto* colours = new QHBoxLayout;
    colours->addWidget(coloured_);
    colours->addStretch();
    colours->addWidget(tolerance_);
    auto* cavity = new QHBoxLayout;
    cavity->addWidget(ghost_);
    cavity->addStretch();
    cavity->addWidget(choose_);
    auto* form = new QFormLayout(this);
    form->addRow(tr("Section"), section_);
    form->addRow(tr("Place"), place);
    form->addRow(tr("Enamel"), enamel_);
    form->addRow(tr("Dentin"), dentin_);
    form->addRow(tr("Depth"), stereo_);
    form->addRow(colours);
    form->addRow(cavity);
    enablePlace();
    connect(section_, &QComboBox::currentIndexChanged, this, &InspectionPanel::enablePlace);
    connect(follows_, &QCheckBox::toggled, this, &InspectionPanel::enablePlace);
    for (QComboBox* box : {section_, stereo_})
        connect(box, &QComboBox::currentIndexChanged, this, &InspectionPanel::changed);
    for (QSlider* each : {place_, enamel_, dentin_})
        connect(each, &QSlider::valueChanged, this, &InspectionPanel::changed);
    connect(ghost_, &QCheckBox::toggled, showGhost_, &QAction::setChecked);
    connect(showGhost_, &QAction::toggled, ghost_, &QCheckBox::setChecked);
    // The tint of the ghost would falsify the colours of the distance.
    connect(coloured_, &QCheckBox::toggled, this, [this](bool on) {
        if (on) ghost_->setChecked(false);
        emit changed();
    });
    connect(ghost_, &QCheckBox::toggled, this, [this](bool on) {
        if (on) coloured_->setChecked(false);
        emit changed();
    });
    connect(tolerance_, &QDoubleSpinBox::valueChanged, this, &InspectionPanel::changed);
    connect(choose_, &QPushButton::clicked, this, &InspectionPanel::targetRequested);
}

Inspection InspectionPanel::inspection(const Box3& box, double mesialX, const MaterialRegistry& materials) const {
    Inspection result;
    if (section_->currentIndex() > 0) {
        const auto side = static_cast<StandardView>(section_->currentIndex() - 1);
        result.section = sectionPlane(side, mesialX, box, kTenth * place_->value());
    }
    const auto share = [](const QSlider* from) { return static_cast<float>(from->value()) / kFull; };
    for (const MaterialId id : materials.ids()) {
        if (materials.hasRole(id, MaterialRole::Enamel)) result.opacity[static_cast<std::size_t>(id)] = share(enamel_);
        if (materials.hasRole(id, MaterialRole::Dentin)) result.opacity[static_cast<std::size_t>(id)] = share(dentin_);
    }
    if (coloured_->isChecked())
        result.distances = DistanceColourMap{target_.distances, {kColourRange, tolerance_->value()}};
    if (ghost_->isChecked()) result.ghost = target_.ghost;
    return result;
}

void InspectionPanel::enablePlace() {
    const bool hasSection = section_->currentIndex() > 0;
    follows_->setEnabled(hasSection);
    place_->setEnabled(hasSection && !follows_->isChecked());
}

void InspectionPanel::followBur(const Vec3& tip, const Box3& box, double mesialX) {
    if (!follows_->isEnabled() || !follows_->isChecked() || !tip.allFinite()) return;
    const auto side = static_cast<StandardView>(section_->currentIndex() - 1);
    const double fromMiddle = viewDirection(side, mesialX).dot(tip - box.center());
    const double farthest = kTenth * kFarthest;
    place_->setValue(static_cast<int>(std::lround(std::clamp(fromMiddle, -farthest, farthest) / kTenth)));
}

Stereo::Mode InspectionPanel::stereo() const { return static_cast<Stereo::Mode>(stereo_->currentIndex()); }

InspectionPanel::Choice InspectionPanel::choice() const {
    return {section_->currentIndex(), place_->value(),         enamel_->value(),
            dentin_->value(),         stereo_->currentIndex(), coloured_->isChecked(),
            ghost_->isChecked(),      tolerance_->value(),     follows_->isChecked()};
}

void InspectionPanel::choose(const Choice& choice) {
    section_->setCurrentIndex(choice.section);
    follows_->setChecked(choice.follows);
    place_->setValue(choice.place);
    enamel_->setValue(choice.enamel);
    dentin_->setValue(choice.dentin);
    stereo_->setCurrentIndex(choice.stereo);
    coloured_->setChecked(choice.coloured && coloured_->isEnabled());
    ghost_->setChecked(choice.ghost && ghost_->isEnabled());
    tolerance_->setValue(choice.tolerance);
}

void InspectionPanel::setTarget(Target target) {
    target_ = std::move(target);
    const bool isThere = target_.distances != nullptr;
    coloured_->setEnabled(isThere);
    coloured_->setChecked(isThere);
    tolerance_->setEnabled(isThere);
    ghost_->setChecked(false);
    explainGhost();
    constexpr int kLetters = 14;  // a longer name would widen the panel
    const QFontMetrics letters = choose_->fontMetrics();
    choose_->setText(isThere ? letters.elidedText(target_.name, Qt::ElideRight, kLetters * letters.averageCharWidth())
                             : tr("Target…"));
    choose_->setToolTip(isThere ? target_.name : tr("An STL file of the ideal shape, in the frame of the tooth"));
    emit changed();
}

/// Explains in the tool tip what the ghost shows, or why there is none.
void InspectionPanel::explainGhost() {
    const bool hasGhost = target_.ghost != nullptr && !target_.ghost->empty();
    const QString tip =
        hasGhost
            ? tr("The cavity of the target as blue glass in the tooth, darker the deeper it lies, with a dark line "
                 "around its opening. Each wall disappears where you have cut as far as it.")
        : target_.ghost != nullptr ? tr("This target has no cavity in the tooth: nothing of it lies inside")
                                   : tr("Choose a target first: the tooth with the ideal cavity");
    ghost_->setToolTip(tip);
    showGhost_->setToolTip(tip);
    ghost_->setEnabled(hasGhost);
    showGhost_->setEnabled(hasGhost);
}

}  // namespace tactooth
