// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/common/scene_builder.h"
#include "geometry/util/expected.h"
#include "haptics/haptic_simulation.h"
#include "session/simulation/spray_particle_system.h"

namespace tactooth {

/// Everything that stays the same in all pictures of a demonstration.
struct DemoProps {
    ShownTool tool;                     ///< each picture sets its pose and spin
    std::optional<ShownMirror> mirror;  ///< each picture sets its pose
    Box3 box;                           ///< of the tooth that is cut, mm
    std::vector<ShownBody> around;      ///< around the tooth
    std::vector<ShownTissue> softTissues;
    MaterialTable materials;
    std::shared_ptr<const AppearanceZones> zones = {};  ///< of the tooth that is cut
    double mesialX = 1;                                 ///< sign of the mesial direction along x
};

/// The subject of a picture.
enum class DemoView {
    Touch,   ///< the bur on the tooth, from the buccal side and above
    AtWork,  ///< the bur at work in its spray, closer
    Cut,     ///< the cavity, closer and steeper, without the instrument, which would block its light
};

/// The state of the session at the moment of a picture.
struct DemoMoment {
    std::shared_ptr<const Surface> tooth;
    const Tick& tick;
    std::span<const SprayParticle> flying = {};
};

/// Writes a picture (PNG, 1600 x 1000) of the tooth and the instrument. Needs no display.
[[nodiscard]] Expected<void> writeDemoPicture(const std::filesystem::path& path, DemoView view,
                                              const DemoMoment& moment, const DemoProps& props);

}  // namespace tactooth
