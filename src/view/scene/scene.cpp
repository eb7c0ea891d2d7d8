// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/scene/scene.h"

#include <algorithm>

namespace tactooth {

namespace {

const TriangleMesh* meshOf(const SceneShape& shape) {
    if (const auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&shape)) return mesh->get();
    const auto& surface = std::get<std::shared_ptr<const Surface>>(shape);
    return surface != nullptr && surface->base != nullptr ? &surface->base->mesh() : nullptr;
}

}  // namespace

float SceneMirror::dimmedReflectance() const { return reflectance * (1 - std::clamp(dirt, 0.0F, 1.0F) / 3); }

Plane SceneMirror::planeInWorld() const {
    const Vec3 worldNormal = mirrorInWorld.rotation * normal;
    return {worldNormal, worldNormal.dot(mirrorInWorld * centre)};
}

Lighting operatingLight(const Camera& camera) {
    const Quat& eye = camera.cameraInWorld.rotation;
    Lighting lighting;
    lighting.toKey = eye * Vec3(-0.42, 0.62, 0.66).normalized();
    lighting.toFill = eye * Vec3(0.75, -0.15, 0.45).normalized();
    return lighting;
}

Box3 boundingBox(const Scene& scene) {
    Box3 all;
    for (const SceneObject& object : scene.objects) {
        const TriangleMesh* mesh = meshOf(object.shape);
        if (!object.visible || mesh == nullptr || mesh->empty()) continue;
        const Box3 box = boundingBox(*mesh);
        for (int corner = 0; corner < 8; ++corner) {
            all.extend(object.objectInWorld * box.corner(static_cast<Box3::CornerType>(corner)));
        }
    }
    return all;
}

}  // namespace tactooth
