// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/shading_mesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace tactooth {

namespace {

/// Small enough that a run of a scanned tooth looks one way (about 0.5 mm across at 60 um per edge), large enough that
/// testing runs costs nothing beside drawing them.
constexpr std::size_t kTrianglesPerCluster = 128;

constexpr std::uint32_t kUnset = 0xFFFFFFFF;

/// Puts two zero bits behind each of the low ten bits.
std::uint32_t spreadBits(std::uint32_t value) {
    std::uint32_t spread = 0;
    for (std::uint32_t bit = 0; bit < 10; ++bit) spread |= ((value >> bit) & 1U) << (3 * bit);
    return spread;
}

/// Place along the Morton curve through `box`.
std::uint32_t mortonCode(const Vec3f& point, const Eigen::AlignedBox3f& box,
                         const std::array<std::uint32_t, 1024>& spread) {
    const Vec3f cell = (point - box.min()).cwiseQuotient(box.sizes().cwiseMax(1e-6F)) * 1023.0F;
    const auto at = [&](int axis) { return spread[static_cast<std::size_t>(std::clamp(cell[axis], 0.0F, 1023.0F))]; };
    return at(0) | (at(1) << 1U) | (at(2) << 2U);
}

std::vector<std::uint32_t> mortonOrder(const TriangleMesh& mesh) {
    std::array<std::uint32_t, 1024> spread{};
    for (std::uint32_t i = 0; i < spread.size(); ++i) spread[i] = spreadBits(i);
    const Eigen::AlignedBox3f box = boundingBox(mesh).cast<float>();
    std::vector<std::uint64_t> keys(mesh.triangles.size());
    for (std::size_t t = 0; t < keys.size(); ++t) {
        const Triangle& triangle = mesh.triangles[t];
        const Vec3f centre =
            (mesh.vertices[triangle[0]] + mesh.vertices[triangle[1]] + mesh.vertices[triangle[2]]) / 3.0F;
        keys[t] = (std::uint64_t{mortonCode(centre, box, spread)} << 32U) | t;
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> order(keys.size());
    std::transform(keys.begin(), keys.end(), order.begin(),
                   [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
    return order;
}

/// Hands out one shading vertex for each position, normal and mix of looks that is used, in order of first use.
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
        const std::uint32_t looks = packLooks(shading_.looks[3 * triangle + corner]);
        std::uint32_t* link = &first_[vertex];
        while (*link != kUnset && (out_[*link].normal != normal || out_[*link].looks != looks)) link = &next_[*link];
        if (*link != kUnset) return *link;
        const auto made = static_cast<std::uint32_t>(out_.size());
        *link = made;
        const Vec3f& position = mesh_.vertices[vertex];
        out_.push_back({{position.x(), position.y(), position.z()}, normal, looks});
        next_.push_back(kUnset);
        return made;
    }

private:
    const TriangleMesh& mesh_;
    const CornerShading& shading_;
    std::vector<ShadingVertex>& out_;
    std::vector<std::uint32_t> first_;  ///< of each mesh vertex, the first shading vertex made from it
    std::vector<std::uint32_t> next_;   ///< of each shading vertex, the next of the same mesh vertex
};

TriangleCluster clusterOf(const ShadingMesh& mesh, std::uint32_t first, std::uint32_t count) {
    const auto point = [&](std::uint32_t vertex) { return Vec3f(mesh.vertices[vertex].position.data()); };
    TriangleCluster cluster;
    cluster.firstTriangle = first;
    cluster.triangles = count;
    Eigen::AlignedBox3f box;
    std::vector<Vec3f> facets;
    facets.reserve(count);
    Vec3f sum = Vec3f::Zero();
    for (std::uint32_t t = first; t < first + count; ++t) {
        const Triangle& triangle = mesh.triangles[t];
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

std::uint32_t packNormal(const Vec3f& normal) {
    const auto bits = [&](int axis) {
        return static_cast<std::uint32_t>(std::lround(std::clamp(normal[axis], -1.0F, 1.0F) * 511.0F)) & 1023U;
    };
    return bits(0) | (bits(1) << 10U) | (bits(2) << 20U);
}

std::uint32_t packLooks(const LookMix& mix) {
    return mix.first | (std::uint32_t{mix.second} << 8U) | (std::uint32_t{mix.share} << 16U);
}

ShadingMesh shadingMesh(const TriangleMesh& mesh, const CornerShading& shading) {
    assert(shading.normals.size() == 3 * mesh.triangles.size() && shading.looks.size() == shading.normals.size());
    ShadingMesh result;
    result.box = boundingBox(mesh);
    result.triangles.resize(mesh.triangles.size());
    result.placeOfTriangle.resize(mesh.triangles.size());
    const std::vector<std::uint32_t> order = mortonOrder(mesh);
    VertexSplitter splitter(mesh, shading, result.vertices);
    for (std::uint32_t place = 0; place < order.size(); ++place) {
        result.placeOfTriangle[order[place]] = place;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            result.triangles[place][corner] = splitter.vertexFor(order[place], corner);
        }
    }
    for (std::size_t first = 0; first < order.size(); first += kTrianglesPerCluster) {
        const std::size_t count = std::min(kTrianglesPerCluster, order.size() - first);
        result.clusters.push_back(
            clusterOf(result, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)));
    }
    return result;
}

}  // namespace tactooth
