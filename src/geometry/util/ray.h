// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// A half line; `direction` is unit.
struct Ray {
    Vec3 origin;
    Vec3 direction;
};

}  // namespace tactooth
