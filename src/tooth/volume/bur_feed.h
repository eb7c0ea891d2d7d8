// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tooth/model/material_registry.h"
#include "tooth/volume/cut_volume.h"

namespace tactooth {

/// How far the removal law let a bur go.
struct FeedResult {
    double fraction = 0;  ///< of the way wanted, 0..1
    double work = 0;      ///< spent, N*m
    double wanted = 0;    ///< that would have paid for a step, where none was affordable, N*m; infinite: no work does
    CarveResult carve;
};

/// Work (normal force times rim travel, N*m) that the removal law asks for these volumes: dV = removal * sharpness *
/// work for each material. Infinite for a bur that does not cut.
[[nodiscard]] double workFor(const MaterialVolumes& volumes, const MaterialTable& materials, double sharpness);

/// Cuts from one pose of the spinning bur toward another as far as `work` (N*m) pays for, and no further. `enough`: a
/// share of the way that is thought to be dearer than that; to look at the rest of it then takes no time.
[[nodiscard]] FeedResult feedBur(CutVolume& volume, const RevolutionEnvelope& envelope, const Pose& from,
                                 const Pose& to, double work, const MaterialTable& materials, double sharpness,
                                 double enough = 1);

/// The pose a fraction of the way from one to the other.
[[nodiscard]] Pose between(const Pose& from, const Pose& to, double fraction);

}  // namespace tactooth
