// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A straight plastic suction tube as a closed surface: the origin is the centre of its round opening, and +z leads
/// into the tube toward the assistant's hand. 6 mm wide, 90 mm long.
[[nodiscard]] TriangleMesh makeSuctionTube();

}  // namespace tactooth
