// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/jaw_frame.h"

#include <algorithm>

#include "geometry/mesh/mesh_specks.h"
#include "patient/dental_arch.h"
#include "patient/length_unit.h"
#include "patient/messages.h"

namespace tactooth {
namespace {

Box3 boxOf(const Scan& scan) {
    Box3 box = boxExcludingSpecks(scan.outer);
    for (const LayerMesh& layer : scan.layers) box.extend(boxExcludingSpecks(layer.mesh));
    return box;
}

/// The centre of the enamel, or of the whole box where there is none.
Vec3 crownOf(const Scan& scan, const Box3& box) {
    for (const LayerMesh& layer : scan.layers) {
        if (scan.materials->hasRole(layer.material, MaterialRole::Enamel))
            return boxExcludingSpecks(layer.mesh).center();
    }
    return box.center();
}

}  // namespace

Expected<JawFrame> findJawFrame(std::span<const Scan> teeth, std::optional<double> mmPerUnit) {
    std::vector<double> longest;
    std::vector<Vec3> crowns;
    for (const Scan& scan : teeth) {
        const Box3 box = boxOf(scan);
        if (box.isEmpty() || box.sizes().maxCoeff() <= 0) return unexpected(msg::kNoSurface, scan.name);
        longest.push_back(box.sizes().maxCoeff());
        crowns.push_back(crownOf(scan, box));
    }
    JawFrame jaw;
    if (mmPerUnit) {
        jaw.mmPerUnit = *mmPerUnit;
    } else {
        std::ranges::sort(longest);
        ScaleGuess guess = guessScale(longest[longest.size() / 2]);
        jaw.mmPerUnit = guess.mmPerUnit;
        jaw.why.push_back(std::move(guess.why));
    }
    for (Vec3& crown : crowns) crown *= jaw.mmPerUnit;
    if (const auto middle = archCentre(crowns)) {
        for (const Vec3& crown : crowns) jaw.buccalDirections.emplace_back(crown - *middle);
    }
    return jaw;
}

}  // namespace tactooth
