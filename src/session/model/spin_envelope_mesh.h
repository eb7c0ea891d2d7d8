// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"
#include "tooth/sweep/revolution_envelope.h"

namespace tactooth {

/// The envelope of a spinning bur as a mesh, tool frame, mm.
[[nodiscard]] TriangleMesh spinEnvelopeMesh(const RevolutionEnvelope& envelope);

}  // namespace tactooth
