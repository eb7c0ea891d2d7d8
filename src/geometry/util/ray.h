// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// A half line from `origin`, mm, along the unit vector `direction`.
struct Ray {
    Vec3 origin;
    Vec3 direction;
};

}  // namespace tactooth
