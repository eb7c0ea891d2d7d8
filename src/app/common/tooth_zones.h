// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "tooth/model/layered_tooth.h"
#include "view/mesh/appearance_zones.h"
#include "view/scene/appearance.h"

namespace tactooth {

/// How the layers of a tooth show through each other: thin enamel is yellow with the dentin below it, and without
/// dentin it is grey; cut enamel is chalky, cut dentin glossy. Around decay come the zones of a lesion: a white spot in
/// the enamel, soft brown decay, leathery amber dentin, darker dentin that the tooth has hardened.
///
/// Cheap: it refers to the surfaces of `tooth`. The result belongs to the appearances of zoneAppearances, appended to
/// those of `materials`, which begin with the materials of `tooth`.
[[nodiscard]] std::shared_ptr<const AppearanceZones> toothZones(const LayeredTooth& tooth,
                                                                const MaterialTable& materials);

/// An appearance that only zones use, and the material that it belongs to: with it, it turns transparent.
struct ZoneAppearance {
    Appearance appearance;
    MaterialId material;
};
[[nodiscard]] std::vector<ZoneAppearance> zoneAppearances(const MaterialRegistry& materials);

}  // namespace tactooth
