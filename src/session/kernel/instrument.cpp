// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/instrument.h"

#include <utility>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

/// A needle, in place of an envelope that is never used: only a spinning bur has one, and a tool may be flat.
const CuttingTool& needle() {
    static const CuttingTool tool = [] {
        constexpr float kWidth = 0.01F;  // mm
        TriangleMesh mesh;
        mesh.vertices = {Vec3f(0, 0, 0), Vec3f(kWidth, 0, 1), Vec3f(0, kWidth, 1), Vec3f(-kWidth, -kWidth, 1)};
        mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
        Expected<RevolutionEnvelope> envelope = RevolutionEnvelope::make(mesh);
        TACTOOTH_ASSERT(envelope);
        return CuttingTool{std::move(*envelope), 1};
    }();
    return tool;
}

}  // namespace

Instrument touchingTool(std::shared_ptr<const ToolShape> shape) {
    TACTOOTH_ASSERT(shape != nullptr);
    return {std::move(shape), needle(), {}, /*cuts=*/false};
}

}  // namespace tactooth
