// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/shading_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "geometry/util/assert.h"

namespace tactooth {

namespace {

constexpr std::uint32_t kUnset = 0xFFFFFFFF;

constexpr std::size_t kSmallestHalf = 32;  ///< triangles; a finer order gains nothing

/// Orders triangles so that each run of 2^k of them, starting at a multiple of 2^k, fills a compact box. It halves the
/// triangles along the longest side of their box, then each half again.
class HalvedBoxes {
public:
    explicit HalvedBoxes(const TriangleMesh& mesh) : order_(mesh.triangles.size()) {
        std::iota(order_.begin(), order_.end(), 0U);
        centres_.reserve(order_.size());
        for (const Triangle& t : mesh.triangles) {
            centres_.push_back((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0F);
        }
        halve(order_);
    }
    [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

private:
    void halve(std::span<std::uint32_t> part) {
        if (part.size() <= kSmallestHalf) {
            std::sort(part.begin(), part.end());
            return;
        }
        Eigen::AlignedBox3f box;
        for (const std::uint32_t triangle : part) box.extend(centres_[triangle]);
        Eigen::Index axis = 0;
        box.sizes().maxCoeff(&axis);
        const std::size_t half = std::bit_ceil(part.size()) / 2;
        std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                         [&](std::uint32_t a, std::uint32_t b) {
                             return std::pair(centres_[a][axis], a) < std::pair(centres_[b][axis], b);
                         });
        halve(part.first(half));
        halve(part.subspan(half));
    }

    std::vector<std::uint32_t> order_;
    std::vector<Vec3f> centres_;
};

/// Makes one shading vertex for each used combination of position, normal and appearance mix, in order of first use.
class VertexSplitter {
public:
    VertexSplitter(const TriangleMesh& mesh, const CornerShading& shading, std::vector<ShadingVertex>& out)
        : mesh_(mesh), shading_(shading), out_(out), first_(mesh.vertices.size(), kUnset) {
        out_.reserve(mesh.vertices.size() + mesh.vertices.size() / 8);
        next_.reserve(out_.capacity());
    }

    std::uint32_t vertexFor(std::uint32_t triangle, std::size_t corner) {
        const std::uint32_t vertex = mesh_.triangles[triangle][corner];
        const std::uint32_t normal = packNormal(shading_.normals[3 * triangle + corner]);
        const std::uint32_t appearances = packAppearances(shading_.appearances[3 * triangle + corner]);
        std::uint32_t* link = &first_[vertex];
        while (*link != kUnset && (out_[*link].normal != normal || out_[*link].appearances != appearances))
            link = &next_[*link];
        if (*link != kUnset) return *link;
        const auto made = static_cast<std::uint32_t>(out_.size());
        *link = made;
        const Vec3f& position = mesh_.vertices[vertex];
        out_.push_back({{position.x(), position.y(), position.z()}, normal, appearances});
        next_.push_back(kUnset);
        return made;
    }

private:
    const TriangleMesh& mesh_;
    const CornerShading& shading_;
    std::vector<ShadingVertex>& out_;
    std::vector<std::uint32_t> first_;  ///< for each mesh vertex, the first shading vertex made from it
    std::vector<std::uint32_t> next_;   ///< for each shading vertex, the next one of the same mesh vertex
};

TriangleCluster clusterOf(std::span<const ShadingVertex> vertices, std::span<const Triangle> triangles,
                          std::uint32_t first, std::uint32_t count) {
    const auto point = [&](std::uint32_t vertex) { return Vec3f(vertices[vertex].position.data()); };
    TriangleCluster cluster;
    cluster.firstTriangle = first;
    cluster.triangles = count;
    Eigen::AlignedBox3f box;
    std::vector<Vec3f> facets;
    facets.reserve(count);
    Vec3f sum = Vec3f::Zero();
    for (std::uint32_t t = first; t < first + count; ++t) {
        const Triangle& triangle = triangles[t];
        for (const std::uint32_t vertex : triangle) box.extend(point(vertex));
        const Vec3f area = (point(triangle[1]) - point(triangle[0])).cross(point(triangle[2]) - point(triangle[0]));
        if (area.squaredNorm() == 0) continue;
        sum += area;
        facets.push_back(area.normalized());
    }
    cluster.centre = box.center();
    cluster.radius = 0.5F * box.diagonal().norm();
    cluster.axis = sum.stableNormalized();
    float cosine = facets.empty() ? 1.0F : 2.0F;
    for (const Vec3f& facet : facets) cosine = std::min(cosine, facet.dot(cluster.axis));
    cluster.coneSine = cosine <= 0 ? 2.0F : std::sqrt(std::max(0.0F, 1 - cosine * cosine));
    return cluster;
}

}  // namespace

void appendClusters(std::span<const ShadingVertex> vertices, std::span<const Triangle> triangles, std::uint32_t first,
                    std::vector<TriangleCluster>& clusters) {
    const auto end = static_cast<std::uint32_t>(triangles.size());
    for (std::uint32_t at = first; at < end; at += kTrianglesPerCluster) {
        clusters.push_back(clusterOf(vertices, triangles, at, std::min(kTrianglesPerCluster, end - at)));
    }
}

std::uint32_t packNormal(const Vec3f& normal) {
    const auto bits = [&](int axis) {
        return static_cast<std::uint32_t>(std::lround(std::clamp(normal[axis], -1.0F, 1.0F) * 511.0F)) & 1023U;
    };
    return bits(0) | (bits(1) << 10U) | (bits(2) << 20U);
}

std::uint32_t packAppearances(const AppearanceMix& mix) {
    return mix.first | (std::uint32_t{mix.second} << 8U) | (std::uint32_t{mix.share} << 16U);
}

ShadingMesh shadingMesh(const TriangleMesh& mesh, const CornerShading& shading) {
    TACTOOTH_ASSERT(shading.normals.size() == 3 * mesh.triangles.size() &&
                    shading.appearances.size() == shading.normals.size());
    ShadingMesh result;
    result.box = boundingBox(mesh);
    result.triangles.resize(mesh.triangles.size());
    result.drawIndexOfTriangle.resize(mesh.triangles.size());
    const HalvedBoxes boxes(mesh);
    const std::vector<std::uint32_t>& order = boxes.order();
    VertexSplitter splitter(mesh, shading, result.vertices);
    for (std::uint32_t place = 0; place < order.size(); ++place) {
        result.drawIndexOfTriangle[order[place]] = place;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            result.triangles[place][corner] = splitter.vertexFor(order[place], corner);
        }
    }
    appendClusters(result.vertices, result.triangles, 0, result.clusters);
    return result;
}

}  // namespace tactooth
