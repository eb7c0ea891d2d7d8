// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/corner_shading.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/util/assert.h"
#include "view/mesh/tag_weights.h"

namespace tactooth {

namespace {

/// Which corners (3 t + c) touch each vertex.
struct CornersOfVertex {
    std::vector<std::uint32_t> begin;
    std::vector<std::uint32_t> corners;

    explicit CornersOfVertex(const TriangleMesh& mesh) : begin(mesh.vertices.size() + 1) {
        for (const Triangle& triangle : mesh.triangles) {
            for (const std::uint32_t vertex : triangle) ++begin[vertex + 1];
        }
        for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
        corners.resize(3 * mesh.triangles.size());
        std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
        for (std::size_t corner = 0; corner < corners.size(); ++corner) {
            corners[next[mesh.triangles[corner / 3][corner % 3]]++] = static_cast<std::uint32_t>(corner);
        }
    }
    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t vertex) const {
        return {corners.data() + begin[vertex], corners.data() + begin[vertex + 1]};
    }
};

/// Twice the area of a facet 20 um wide, mm^2. A smaller facet is a sliver left by cutting. Its direction says nothing
/// about the surrounding wall.
constexpr float kTrustedArea = 4e-4F;

struct Facets {
    std::vector<Vec3f> normals;  ///< one per triangle; zero if it has no area
    std::vector<float> weights;  ///< one per corner: its angle, rad, or less

    explicit Facets(const TriangleMesh& mesh) : normals(mesh.triangles.size()), weights(3 * mesh.triangles.size()) {
        for (std::size_t t = 0; t < normals.size(); ++t) {
            const std::array<Vec3f, 3> p = {mesh.vertices[mesh.triangles[t][0]], mesh.vertices[mesh.triangles[t][1]],
                                            mesh.vertices[mesh.triangles[t][2]]};
            const Vec3f doubleArea = (p[1] - p[0]).cross(p[2] - p[0]);
            normals[t] = doubleArea.stableNormalized();
            const float trust = std::min(1.0F, doubleArea.norm() / kTrustedArea);
            for (std::size_t c = 0; c < 3; ++c) {
                const Vec3f a = p[(c + 1) % 3] - p[c];
                const Vec3f b = p[(c + 2) % 3] - p[c];
                weights[3 * t + c] = trust * std::atan2(a.cross(b).norm(), a.dot(b));
            }
        }
    }
};

constexpr std::uint8_t kNoGroup = 255;
constexpr std::uint8_t kMaxGroups = 254;

class SmoothingGroups {
public:
    SmoothingGroups(const TriangleMesh& mesh, const Facets& facets, std::span<const SurfaceTag> tags)
        : mesh_(mesh),
          facets_(facets),
          tags_(tags),
          groups_(3 * mesh.triangles.size(), kNoGroup),
          shading_{std::vector<Vec3f>(3 * mesh.triangles.size()),
                   std::vector<AppearanceMix>(3 * mesh.triangles.size())} {}

    [[nodiscard]] CornerShading takeShading() { return std::move(shading_); }

    void group(std::span<const std::uint32_t> corners) {
        std::uint8_t groups = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (groups_[corners[i]] != kNoGroup) continue;
            flood(corners, corners[i], groups);
            if (groups < kMaxGroups) ++groups;
        }
        for (std::uint8_t g = 0; g < groups; ++g) shade(corners, g);
    }

private:
    /// Assigns `group` to `seed` and to every corner connected to it by smooth edges.
    void flood(std::span<const std::uint32_t> corners, std::uint32_t seed, std::uint8_t group) {
        front_.assign(1, seed);
        groups_[seed] = group;
        while (!front_.empty()) {
            const std::uint32_t current = front_.back();
            front_.pop_back();
            for (const std::uint32_t other : corners) {
                if (groups_[other] != kNoGroup || !smooth(current, other)) continue;
                groups_[other] = group;
                front_.push_back(other);
            }
        }
    }

    [[nodiscard]] bool smooth(std::uint32_t a, std::uint32_t b) const {
        const std::uint32_t ta = a / 3;
        const std::uint32_t tb = b / 3;
        const Triangle& left = mesh_.triangles[ta];
        const Triangle& right = mesh_.triangles[tb];
        const std::uint32_t after = left[(a + 1 - 3 * ta) % 3];
        const std::uint32_t before = left[(a + 2 - 3 * ta) % 3];
        const bool shareAnEdge = after == right[(b + 2 - 3 * tb) % 3] || before == right[(b + 1 - 3 * tb) % 3];
        static const float kCreaseCosine = static_cast<float>(std::cos(kCreaseAngle));
        return shareAnEdge && facets_.normals[ta].dot(facets_.normals[tb]) >= kCreaseCosine;
    }

    void shade(std::span<const std::uint32_t> corners, std::uint8_t group) {
        Vec3f sum = Vec3f::Zero();
        shares_.clear();
        for (const std::uint32_t corner : corners) {
            if (groups_[corner] != group) continue;
            sum += facets_.weights[corner] * facets_.normals[corner / 3];
            shares_.add(tags_.empty() ? SurfaceTag{0} : tags_[corner / 3], facets_.weights[corner]);
        }
        const Vec3f normal = sum.squaredNorm() > 0 ? sum.normalized().eval() : Vec3f::UnitZ().eval();
        const AppearanceMix mix = shares_.mix();
        for (const std::uint32_t corner : corners) {
            if (groups_[corner] != group) continue;
            shading_.normals[corner] = normal;
            shading_.appearances[corner] = mix;
        }
    }

    const TriangleMesh& mesh_;
    const Facets& facets_;
    std::span<const SurfaceTag> tags_;
    std::vector<std::uint8_t> groups_;  ///< group numbers within each vertex, from 0, one entry per corner
    CornerShading shading_;
    TagWeights shares_;
    std::vector<std::uint32_t> front_;
};

}  // namespace

CornerShading cornerShading(const TriangleMesh& mesh, std::span<const SurfaceTag> tags) {
    TACTOOTH_ASSERT(tags.empty() || tags.size() == mesh.triangles.size());
    const Facets facets(mesh);
    const CornersOfVertex cornersOfVertex(mesh);
    SmoothingGroups grouping(mesh, facets, tags);
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) grouping.group(cornersOfVertex.of(vertex));
    return grouping.takeShading();
}

}  // namespace tactooth
