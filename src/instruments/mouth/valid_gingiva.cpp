// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mouth/valid_gingiva.h"

#include "geometry/util/assert.h"
#include "instruments/messages.h"

namespace tactooth {

Expected<TriangleMesh> firstValidGingiva(double cell, const std::function<GingivaCandidate(double cell)>& gingivaAt,
                                         const Message& ofMouth) {
    TACTOOTH_ASSERT(cell > 0 && gingivaAt != nullptr);
    constexpr int kTries = 8;
    constexpr double kFiner = 0.97;  // another grid, which meets a thin wall elsewhere
    for (int i = 0; i < kTries; ++i, cell *= kFiner) {
        GingivaCandidate gum = gingivaAt(cell);
        if (!gum.selfIntersects) return std::move(gum.mesh);
    }
    return unexpected(msg::kGingivaCrossesItself, ofMouth, kTries);
}

}  // namespace tactooth
