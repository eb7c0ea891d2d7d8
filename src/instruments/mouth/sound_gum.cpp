// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mouth/sound_gum.h"

namespace tactooth {

Expected<TriangleMesh> firstSoundGum(double cell, const std::function<TriedGum(double cell)>& gumAt,
                                     const std::string& ofMouth) {
    constexpr int kTries = 8;
    constexpr double kFiner = 0.97;  // another grid, which meets a thin wall elsewhere
    for (int i = 0; i < kTries; ++i, cell *= kFiner) {
        TriedGum gum = gumAt(cell);
        if (!gum.crossesItself) return std::move(gum.mesh);
    }
    return unexpected(ofMouth + " crosses itself at each of the " + std::to_string(kTries) +
                      " finenesses that were tried; ask for another number of triangles or another seed.");
}

}  // namespace tactooth
