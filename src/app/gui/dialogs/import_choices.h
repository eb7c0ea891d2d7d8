// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "geometry/mesh/mesh_repair.h"

class QComboBox;

namespace tactooth {

// The choices that an import of one tooth and that of a whole folder have in common.

/// Lists the units of length, beginning with one that is guessed.
void fillUnits(QComboBox& units);
/// mm per unit; nothing: it is guessed.
[[nodiscard]] std::optional<double> chosenUnit(const QComboBox& units);

void fillHoles(QComboBox& holes);
[[nodiscard]] HolesToFill chosenHoles(const QComboBox& holes);

/// What is inside a surface without layers.
void fillInside(QComboBox& inside);
/// Whether layers are modelled.
[[nodiscard]] bool modelsLayers(const QComboBox& inside);

}  // namespace tactooth
