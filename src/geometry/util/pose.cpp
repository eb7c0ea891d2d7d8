// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/pose.h"

namespace tactooth {

Quat shortestRotation(const Vec3& from, const Vec3& to) { return Quat::FromTwoVectors(from, to); }

}  // namespace tactooth
