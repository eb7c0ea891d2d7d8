// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability_specimens.h"

#include <span>
#include <vector>

namespace tactooth {
namespace {

constexpr float kHalfWidth = 40;   // mm, of the piece in x and y: a soft spring lets the hand go far ahead of the bur
constexpr float kUnderside = -60;  // mm

/// A point of a profile: x, z.
struct ProfilePoint {
    float x, z;
};

/// The prism below a profile that runs from the left to the right, column by column; upright steps are allowed.
TriangleMesh prismBelow(std::span<const ProfilePoint> profile) {
    TriangleMesh mesh;
    for (const auto& [x, z] : profile) {
        for (const float height : {z, kUnderside}) {
            for (const float y : {-kHalfWidth, kHalfWidth}) mesh.vertices.push_back({x, y, height});
        }
    }
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    // Of a point: 0 front top, 1 rear top, 2 front underside, 3 rear underside.
    const auto last = static_cast<std::uint32_t>(4 * (profile.size() - 1));
    quad(1, 3, 2, 0);
    quad(last, last + 2, last + 3, last + 1);
    for (std::uint32_t a = 0, b = 4; a < last; a += 4, b += 4) {
        quad(a, b, b + 1, a + 1);
        if (mesh.vertices[a].x() == mesh.vertices[b].x()) continue;
        quad(a + 3, b + 3, b + 2, a + 2);
        quad(a + 2, b + 2, b, a);
        quad(a + 1, b + 1, b + 3, a + 3);
    }
    return mesh;
}

std::shared_ptr<const Surface> pieceOf(std::span<const ProfilePoint> profile, MaterialId material) {
    TriangleMesh mesh = prismBelow(profile);
    const std::vector<SurfaceTag> tags(mesh.triangles.size(), static_cast<SurfaceTag>(material));
    auto surface = std::make_shared<Surface>();
    surface->closed = true;
    surface->base = std::make_shared<const SurfacePart>(std::move(mesh), tags);
    return surface;
}

}  // namespace

std::shared_ptr<const Surface> flatSpecimen(MaterialId material) {
    const ProfilePoint profile[] = {{-kHalfWidth, 0}, {kHalfWidth, 0}};
    return pieceOf(profile, material);
}

std::shared_ptr<const Surface> ridgeSpecimen(MaterialId material) {
    const ProfilePoint profile[] = {{-kHalfWidth, -kHalfWidth}, {0, 0}, {kHalfWidth, -kHalfWidth}};
    return pieceOf(profile, material);
}

std::shared_ptr<const Surface> grooveSpecimen(MaterialId material) {
    constexpr float kDepth = kGrooveDepth;
    const ProfilePoint profile[] = {{-kHalfWidth, 0}, {-kDepth, 0}, {0, -kDepth}, {kDepth, 0}, {kHalfWidth, 0}};
    return pieceOf(profile, material);
}

std::shared_ptr<const Surface> slotSpecimen(MaterialId material) {
    constexpr auto halfWidth = static_cast<float>(1.1 * kStandardBurRadius);
    constexpr float kDepth = kSlotDepth;
    const ProfilePoint profile[] = {{-kHalfWidth, 0},     {-halfWidth, 0}, {-halfWidth, -kDepth},
                                    {halfWidth, -kDepth}, {halfWidth, 0},  {kHalfWidth, 0}};
    return pieceOf(profile, material);
}

}  // namespace tactooth
