// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/spin_envelope_mesh.h"

#include "instruments/modelling/surface_of_revolution.h"

namespace tactooth {

TriangleMesh spinEnvelopeMesh(const RevolutionEnvelope& envelope) {
    std::vector<OutlinePoint> outline;
    for (const auto& [radius, z] : envelope.profile()) outline.push_back({radius, z});
    constexpr int kSides = 48;
    return revolved(outline, kSides);
}

}  // namespace tactooth
