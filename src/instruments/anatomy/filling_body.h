// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "instruments/anatomy/tooth_shape.h"
#include "instruments/builtin_tooth.h"

namespace tactooth {

/// A filling as a body: a box with a flat floor, upright walls and round ends and edges, twice as long as wide along
/// the fissure or the gum. It protrudes from the tooth; intersect it with the tooth. Width and depth are positive.
[[nodiscard]] ScalarField fillingBody(const ToothShape& shape, const Filling& filling);

}  // namespace tactooth
