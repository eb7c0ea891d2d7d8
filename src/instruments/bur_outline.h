// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "instruments/bur_catalogue.h"
#include "instruments/modelling/surface_of_revolution.h"

namespace tactooth {

/// The outline of a bur's head: the profile that its blade edges or grains sweep when it turns, from the first ring
/// around the tip to the end of the head; the tip itself is at (0, 0). It has about `count` corners (a few more where
/// the shape has more pieces), all exactly on the shape. Its widest point and its end are always among them.
[[nodiscard]] std::vector<OutlinePoint> burOutline(const BurSpec& spec, int count);

/// Radius of the bur's end: of the largest ball on the axis that touches the tip and stays inside the head, mm. 0 for
/// a flat end.
[[nodiscard]] double endRadius(const BurSpec& spec);

}  // namespace tactooth
