// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>

#include "view/gl/drawable.h"

namespace tactooth {

/// Keeps the buffers of the shapes of the last scene, so that the next scene uploads only new shapes.
class ShapeCache {
public:
    struct Result {
        std::vector<Drawable> drawables;   ///< the visible objects of the scene except the ghosts, in scene order
        std::vector<Drawable> ghosts;      ///< the visible ghosts, in scene order
        std::vector<Drawable> capped;      ///< the objects that a section shows filled; empty without a section
        bool staticShapesRemoved = false;  ///< a shape that does not move was removed
        std::size_t uploadedTriangles = 0;
    };
    /// `scene` must live as long as the result.
    [[nodiscard]] Result update(const Scene& scene);

private:
    struct Entry {
        SurfaceBuffers buffers;
        bool used = false;
        bool castsStaticShadow = true;
    };
    [[nodiscard]] Entry& entryFor(const SceneObject& object);
    std::list<Entry> entries_;
};

}  // namespace tactooth
