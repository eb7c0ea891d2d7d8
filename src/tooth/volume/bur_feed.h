// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tooth/model/material_registry.h"
#include "tooth/volume/carve_result.h"
#include "tooth/volume/cut_volume.h"

namespace tactooth {

/// Result of a feed under the removal law.
struct FeedResult {
    double fraction = 0;  ///< of the path, 0..1; 0: at most the clearance around the bur where it is was cut
    double work = 0;      ///< that the cut has used, N*m
    /// Least work that a step was found to need, N*m, if the given work sufficed for no step. May be infinite.
    double requiredWork = 0;
    CarveResult carve;
};

/// Work (normal force times rim travel, N*m) that these volumes need: dV = removal * sharpness * work for each
/// material. `sharpness` is not negative. Infinite for a bur that does not cut.
[[nodiscard]] double workFor(const MaterialVolumes& volumes, const MaterialTable& materials, double sharpness);

/// Cuts from one pose of the spinning bur toward another (both in the tooth's frame), as far as `work` (N*m, not
/// negative) suffices. `enough` (above 0) saves time: an estimate of the fraction of the path that needs more than
/// `work`. The whole path is planned only if that fraction needs less.
[[nodiscard]] FeedResult feedBur(CutVolume& volume, const RevolutionEnvelope& envelope, const Pose& from,
                                 const Pose& to, double work, const MaterialTable& materials, double sharpness,
                                 double enough = 1);

/// The pose at a fraction of the path, not negative. From 1 on it is `to`.
[[nodiscard]] Pose between(const Pose& from, const Pose& to, double fraction);

}  // namespace tactooth
