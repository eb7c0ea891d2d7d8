// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/pose.h"

#include "geometry/util/assert.h"

namespace tactooth {

Quat shortestRotation(const Vec3& from, const Vec3& to) {
    TACTOOTH_ASSERT(from.allFinite() && !from.isZero(0));
    TACTOOTH_ASSERT(to.allFinite() && !to.isZero(0));
    return Quat::FromTwoVectors(from, to);
}

}  // namespace tactooth
