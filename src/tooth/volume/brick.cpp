// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/brick.h"

#include "geometry/util/assert.h"

namespace tactooth {

void CutField::validate(double spacing) const {
    const auto band = static_cast<float>(kCutBand * spacing);
    for (int node = 0; node < kBrickNodes; ++node) {
        TACTOOTH_ASSERT(cut[node] >= -band && cut[node] <= band);
        TACTOOTH_ASSERT(isCut || cut[node] == band);
        TACTOOTH_ASSERT(std::abs(cutNormal[node].unpack().squaredNorm() - 1) < 1e-9);
        for (const auto& crossings : boundary) {
            TACTOOTH_ASSERT(crossings[node].place >= 0 && crossings[node].place <= 1);
        }
    }
}

void Brick::validate(double spacing) const {
    CutField::validate(spacing);
    const auto band = static_cast<float>(kToothBand * spacing);
    float greatest = -kUnknown;
    for (int node = 0; node < kBrickNodes; ++node) {
        TACTOOTH_ASSERT(removed[node] == (cut[node] < 0));
        TACTOOTH_ASSERT(tooth[node] >= -band && tooth[node] <= band);
        TACTOOTH_ASSERT(std::abs(toothNormal[node].unpack().squaredNorm() - 1) < 1e-9);
        TACTOOTH_ASSERT(!opened[node] || lowered[node]);
        greatest = std::max(greatest, tooth[node]);
    }
    TACTOOTH_ASSERT(maxToothDistance == greatest);
}

}  // namespace tactooth
