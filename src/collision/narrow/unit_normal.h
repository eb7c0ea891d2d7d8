// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/util/vec.h"

namespace tactooth {

/// Whether a vector has length 1, to what a few operations in single precision may lose. For asserts.
template <class Vector>
[[nodiscard]] inline bool isUnit(const Vector& v) {
    return std::abs(static_cast<double>(v.squaredNorm()) - 1) < 1e-5;
}

}  // namespace tactooth
