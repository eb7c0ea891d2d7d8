// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/io/stl_reader.h"
#include "geometry/util/pose.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {

/// A tooth of some 325,000 triangles to mill; a ball where there is no real one.
inline TriangleMesh largeTooth() {
    if (const auto folder = test::realTeethFolder()) {
        if (auto real = readStl(*folder / "microct-meshes/tooth_2_outer.stl")) return std::move(*real);
    }
    std::fputs("No real tooth ($TACTOOTH_DATA is not set): a ball takes its place.\n", stderr);
    return test::sphere(Vec3::Zero(), 6, 570, 286);
}

/// The bur after `length` mm of its path: down into the tooth, then to and fro along y, each time further along x,
/// which begins at `firstX` mm from the tooth's middle.
inline Pose poseAlongPath(const Box3& tooth, double length, double firstX) {
    constexpr double kPlunge = 3.0;
    constexpr double kSlot = 3.0;
    const double along = std::max(0.0, length - kPlunge);
    const double phase = std::fmod(along, 2 * kSlot);
    const double y = phase < kSlot ? phase : 2 * kSlot - phase;
    const double x = firstX + 0.4 * std::floor(along / kSlot);
    return {tooth.center() + Vec3(x, y - 0.5 * kSlot, 0.5 * tooth.sizes().z() + 0.5 - std::min(length, kPlunge)),
            Quat::Identity()};
}

}  // namespace tactooth
