// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mouth/soft_tissues.h"

#include <cmath>
#include <optional>
#include <utility>

#include "geometry/util/assert.h"
#include "instruments/mouth/mouth_lining.h"
#include "instruments/mouth/neck_curve.h"
#include "instruments/mouth/tongue.h"

namespace tactooth {

namespace {

/// Where along the lower jaw a tooth stands; nothing for an upper tooth or none.
std::optional<double> placeOnLowerJaw(const NeckCurve& lower, std::span<const Pose> right, int fdi) {
    if (fdi < 30) return std::nullopt;
    const auto place = static_cast<std::size_t>(fdi % 10 - 1);
    TACTOOTH_ASSERT(place < right.size());
    const bool isRight = fdi / 10 == 4;
    return (isRight ? 1 : -1) * lower.lengthTo(std::abs(right[place].position.x()));
}

}  // namespace

std::vector<SoftTissue> makeSoftTissues(std::span<const Pose> toothInMouth, const Pose& lowerJaw, int worked) {
    TACTOOTH_ASSERT(toothInMouth.size() % 2 == 0);
    const std::size_t half = toothInMouth.size() / 2;
    const NeckCurve upper(toothInMouth.first(half)), lower(toothInMouth.subspan(half));
    const MouthLining lining(upper, lower, lowerJaw);
    ZonedMesh tongue = makeTongue(lower, placeOnLowerJaw(lower, toothInMouth.subspan(half), worked));
    tongue.mesh = transformed(tongue.mesh, lowerJaw);
    return {{SoftTissueKind::Tongue, std::move(tongue)}, {SoftTissueKind::Cheek, lining.cheek(false)},
            {SoftTissueKind::Cheek, lining.cheek(true)}, {SoftTissueKind::Lips, lining.lips()},
            {SoftTissueKind::Throat, lining.throat()},   {SoftTissueKind::Ring, lining.retractor()}};
}

}  // namespace tactooth
