// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A straight suction tube of plastic as a closed surface: the middle of its round opening is the origin, +z leads into
/// the tube and on to the assistant's hand. 6 mm wide, 90 mm long.
[[nodiscard]] TriangleMesh makeSuctionTube();

}  // namespace tactooth
