// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/spin_blur.h"

#include <algorithm>

#include "instruments/modelling/lathe.h"

namespace tactooth {

TriangleMesh spinningShape(const RevolutionEnvelope& envelope) {
    std::vector<OutlinePoint> outline;
    for (const auto& [radius, z] : envelope.profile()) outline.push_back({radius, z});
    constexpr int kSides = 48;
    return turned(outline, kSides);
}

float blurOf(double speedRpm) {
    constexpr double kBlades = 8;                // of a carbide bur: 6 to 12
    constexpr double kPicturesPerMinute = 1500;  // 25 a second
    return static_cast<float>(std::clamp(speedRpm * kBlades / kPicturesPerMinute, 0.0, 1.0));
}

}  // namespace tactooth
