// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/util/pose.h"
#include "instruments/mouth/zoned_mesh.h"

namespace tactooth {

enum class SoftTissueKind {
    Tongue,  ///< with the floor of the mouth, closed; zones: floor, side of the tongue, its back
    Cheek,   ///< of one side, with the inner side of the lips, open; one zone
    Lips,    ///< open; zones: inner side, red border, skin
    Throat,  ///< with the soft palate, open; zones: soft palate, throat, its depth
    Ring,    ///< a retractor that holds the lips, closed; one zone
};

/// A part of what surrounds the jaws of an open mouth. It is there to be seen, not to be touched. The front faces of
/// open surfaces point to where a dentist sees them from: from behind they do not hide the teeth.
struct SoftTissue {
    SoftTissueKind kind;
    ZonedMesh shown;
};

/// Soft tissues that fit these teeth: `toothInMouth` has the poses of the teeth of one side, first the upper jaw from
/// the central incisor to the third molar, then the lower jaw, with the mouth closed (MouthLayout). Mouth frame, with
/// the mouth open. At the tooth `worked` (FDI number; 0: none) of the lower jaw the tongue is held aside, as by a
/// mirror; else the two sides are mirror images. The same arguments give the same bits.
[[nodiscard]] std::vector<SoftTissue> makeSoftTissues(std::span<const Pose> toothInMouth, const Pose& lowerJaw,
                                                      int worked);

}  // namespace tactooth
