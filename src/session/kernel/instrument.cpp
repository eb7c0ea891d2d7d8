// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/instrument.h"

#include <utility>

#include "geometry/util/assert.h"
#include "instruments/modelling/surface_of_revolution.h"

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

/// Takes what the spoon fills as the fingers roll it.
const CuttingTool& spoon() {
    static const CuttingTool tool = [] {
        constexpr int kSides = 24;
        Expected<RevolutionEnvelope> envelope = RevolutionEnvelope::make(revolved(spoonOutline(), kSides));
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

Instrument handTool(HandInstrument kind) {
    return handTool(kind, std::make_shared<const ToolShape>(touchingInstrument(kind)));
}

Instrument handTool(HandInstrument kind, std::shared_ptr<const ToolShape> shape) {
    TACTOOTH_ASSERT(shape != nullptr);
    const bool scrapes = kind == HandInstrument::Excavator;
    return {std::move(shape), scrapes ? spoon() : needle(), {}, /*cuts=*/false, kind};
}

}  // namespace tactooth
