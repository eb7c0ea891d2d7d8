// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/common/scene_builder.h"
#include "geometry/expected.h"
#include "haptics/haptic_simulation.h"

namespace tactooth {

/// What stays the same in all pictures of a demonstration.
struct DemoProps {
    ShownTool tool;  ///< its pose and spin are set for each picture
    std::optional<ShownMirror> mirror;
    MaterialTable materials;
};

/// Where the pictures are taken from: from the buccal side, over the crown.
[[nodiscard]] Camera demoCamera(const Box3& tooth);

/// Writes a picture (PNG, 1600 x 1000) of the tooth and the instrument at `tick`. Needs no display.
[[nodiscard]] Expected<void> writeDemoPicture(const std::filesystem::path& path,
                                              const std::shared_ptr<const Surface>& tooth, const DemoProps& props,
                                              const Tick& tick);

}  // namespace tactooth
