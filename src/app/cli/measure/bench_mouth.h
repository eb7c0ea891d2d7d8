// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/expected.h"
#include "view/scene/scene.h"

namespace tactooth {

/// Makes the scene of the whole built-in mouth, open: 32 teeth of about 20,000 triangles each, the gingiva of both
/// jaws, and a mouth mirror behind the lower right molars.
[[nodiscard]] Expected<Scene> benchMouth(bool withSoftTissues);

}  // namespace tactooth
