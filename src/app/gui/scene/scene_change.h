// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "app/common/scene_builder.h"
#include "app/gui/scene/frame_pacer.h"

namespace tactooth {

/// What the user would see change from the scene that was drawn to the present one. `seesTip`: whether the bur may be
/// visible; asked only if nothing else has changed.
[[nodiscard]] FramePacer::Change sceneChange(const SceneContents& now, const SceneContents& drawn,
                                             const std::function<bool()>& seesTip);

}  // namespace tactooth
