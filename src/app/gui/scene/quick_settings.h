// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "view/gl/egl_context.h"
#include "view/scene/render_settings.h"

namespace tactooth {

/// The settings of the current context while things move, before a graphics card has shown that it can do more. To
/// smooth edges on the processor costs little only where it also draws.
[[nodiscard]] inline const RenderSettings& quickSettings() {
    return isSoftwareRenderer(rendererName()) ? kMoving : kQuick;
}

}  // namespace tactooth
