// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/shape_cache.h"

#include <algorithm>

namespace tactooth {

ShapeCache::Entry& ShapeCache::entryFor(const SceneObject& object) {
    const auto known = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
        return !entry.used && entry.buffers.holds(object.shape);
    });
    if (known != entries_.end()) return *known;
    entries_.push_back({.buffers = SurfaceBuffers(object.shape, object.zones)});
    return entries_.back();
}

ShapeCache::Result ShapeCache::update(const Scene& scene) {
    Result result;
    for (Entry& entry : entries_) entry.used = false;
    for (const SceneObject& object : scene.objects) {
        if (!hasTriangles(object.shape)) continue;
        Entry& entry = entryFor(object);
        entry.used = true;
        entry.castsStaticShadow = !object.moves && throwsShadow(object);
        const bool onlyInSection = !object.visible && object.capAppearance && scene.section;
        if (!object.visible && !onlyInSection) continue;
        const bool changed = entry.buffers.update(object.shape);
        if (changed) result.uploadedTriangles += entry.buffers.lastUpload();
        Drawable drawable{&object, &entry.buffers, objectToWorld(object)};
        if (changed) drawable.changed = entry.buffers.changed();
        if (object.capAppearance && scene.section) result.capped.push_back(drawable);
        if (onlyInSection) continue;
        if (object.ghost) {
            result.ghosts.push_back(drawable);
            continue;
        }
        result.drawables.push_back(drawable);
    }
    std::erase_if(entries_, [&](const Entry& entry) {
        result.staticShapesRemoved |= !entry.used && entry.castsStaticShadow;
        return !entry.used;
    });
    return result;
}

}  // namespace tactooth
