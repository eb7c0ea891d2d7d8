// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "view/scene.h"

namespace tactooth {

/// A whole mouth to be drawn: 32 teeth of about 20,000 triangles each on two arches, the gums around their necks, and a
/// mouth mirror in front of the lower molars. What counts is how much there is to draw, not its anatomy.
[[nodiscard]] Scene benchMouth();

}  // namespace tactooth
