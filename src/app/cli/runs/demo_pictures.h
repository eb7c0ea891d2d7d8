// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/common/scene_builder.h"
#include "geometry/util/expected.h"
#include "haptics/haptic_simulation.h"
#include "session/simulation/spray_particle_system.h"

namespace tactooth {

/// What stays the same in all pictures of a demonstration.
struct DemoProps {
    ShownTool tool;                     ///< its pose and spin are set for each picture
    std::optional<ShownMirror> mirror;  ///< its pose too
    Box3 box;                           ///< of the tooth that is worked on, mm
    std::vector<ShownBody> around;      ///< the tooth
    MaterialTable materials;
    double mesialX = 1;  ///< direction of mesial along x
};

/// What a picture is of.
enum class DemoView {
    Touch,   ///< the bur on the tooth, from the buccal side and above
    AtWork,  ///< the bur at work in its spray, nearer
    Cut,     ///< the cavity, nearer and steeper; the instrument, which would stand in its light, is taken away
};

/// What a picture shows of one moment.
struct DemoMoment {
    std::shared_ptr<const Surface> tooth;
    const Tick& tick;
    std::span<const SprayParticle> flying = {};
};

/// Writes a picture (PNG, 1600 x 1000) of the tooth and the instrument. Needs no display.
[[nodiscard]] Expected<void> writeDemoPicture(const std::filesystem::path& path, DemoView view,
                                              const DemoMoment& moment, const DemoProps& props);

}  // namespace tactooth
