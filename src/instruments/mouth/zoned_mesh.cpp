// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mouth/zoned_mesh.h"

#include <algorithm>
#include <cmath>

namespace tactooth {

std::uint8_t ZonedMesh::zoneOf(double share) {
    return static_cast<std::uint8_t>(std::lround(kSecond * std::clamp(share, 0.0, 2.0)));
}

}  // namespace tactooth
