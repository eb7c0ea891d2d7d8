// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/expected.h"
#include "view/scene/scene.h"

namespace tactooth {

/// The whole built-in mouth to be drawn, open: 32 teeth of about 20,000 triangles each, the gums of both jaws, and a
/// mouth mirror behind the lower right molars.
[[nodiscard]] Expected<Scene> benchMouth();

}  // namespace tactooth
