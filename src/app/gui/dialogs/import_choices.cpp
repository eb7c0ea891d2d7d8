// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/import_choices.h"

#include <QComboBox>

#include "app/gui/dialogs/import_dialog.h"
#include "patient/length_unit.h"

namespace tactooth {

void fillUnits(QComboBox& units) {
    units.setObjectName("units");
    units.addItem(ImportDialog::tr("Guessed"), QVariant());
    for (const LengthUnit& unit : kLengthUnits) units.addItem(unit.name, unit.mm);
}

std::optional<double> chosenUnit(const QComboBox& units) {
    if (!units.currentData().isValid()) return std::nullopt;
    return units.currentData().toDouble();
}

void fillHoles(QComboBox& holes) {
    holes.setObjectName("holes");
    holes.addItem(ImportDialog::tr("Fill small ones"), static_cast<int>(HolesToFill::Small));
    holes.addItem(ImportDialog::tr("Fill all of them"), static_cast<int>(HolesToFill::All));
    holes.addItem(ImportDialog::tr("Leave them open"), static_cast<int>(HolesToFill::None));
}

HolesToFill chosenHoles(const QComboBox& holes) { return static_cast<HolesToFill>(holes.currentData().toInt()); }

void fillInside(QComboBox& inside) {
    inside.setObjectName("inside");
    inside.addItem(ImportDialog::tr("A model of enamel, dentin and pulp"), true);
    inside.addItem(ImportDialog::tr("Enamel all through"), false);
}

bool modelsLayers(const QComboBox& inside) { return inside.currentData().toBool(); }

}  // namespace tactooth
