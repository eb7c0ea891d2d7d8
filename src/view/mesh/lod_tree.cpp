// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/lod_tree.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <limits>

#include "geometry/util/parallel_for.h"

// Each step joins two adjacent pieces, keeps the border of the pair and removes half of the triangles. This is the
// binary case of P. Cignoni et al., Batched multi triangulation, IEEE Visualization 2005. Edges are removed in the
// order of the error quadrics of M. Garland, P. Heckbert, Surface simplification using quadric error metrics, SIGGRAPH
// 1997, as meshoptimizer implements them.

namespace tactooth {

namespace {

constexpr double kWorthwhile = 0.75;  ///< a larger share of the triangles saves too little to keep the coarser piece
constexpr std::size_t kFewestTriangles = 64;  ///< half a cluster: fewer triangles are drawn no faster
constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();
constexpr float kNotDrawn = std::numeric_limits<float>::infinity();

/// The triangles of one node.
struct Piece {
    std::vector<Triangle> triangles;
    float error = 0;      ///< of `triangles`
    bool isDrawn = true;  ///< if false, it is only an input of the piece above it
};

/// Where a vertex stands between its two appearances: from the number of the first to that of the second.
float blendOf(std::uint32_t appearances) {
    const auto first = static_cast<float>(appearances & 255U), second = static_cast<float>(appearances >> 8 & 255U);
    return first + (second - first) * static_cast<float>(appearances >> 16 & 255U) / 255;
}

/// Whether at most two appearances meet in the triangle, and pass into each other slowly: at a border between two
/// tissues all triangles stay as they are.
bool isGradual(const ShadingMesh& mesh, const Triangle& triangle) {
    constexpr float kSlow = 0.25F;
    std::array<std::uint32_t, 6> met;
    std::array<float, 3> blends;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t mix = mesh.vertices[triangle[c]].appearances;
        const std::uint32_t first = mix & 255U, second = mix >> 8 & 255U, share = mix >> 16 & 255U;
        met[2 * c] = share < 255 ? first : second;
        met[2 * c + 1] = share > 0 ? second : first;
        blends[c] = blendOf(mix);
    }
    const auto [low, high] = std::ranges::minmax(met);
    const auto [least, most] = std::ranges::minmax(blends);
    return std::ranges::all_of(met, [&](std::uint32_t one) { return one == low || one == high; }) &&
           most - least <= kSlow * static_cast<float>(high - low);
}

/// Triangles with local vertex numbers, because the work of simplification grows with the numbers.
struct LocalMesh {
    std::vector<std::uint32_t> vertices;  ///< numbers in the whole mesh
    std::vector<Vec3f> positions;         ///< raised by what the appearance there differs
    std::vector<std::uint32_t> indices;

    LocalMesh(const ShadingMesh& mesh, std::span<const Triangle> triangles) {
        std::uint32_t low = kNoVertex, high = 0;
        for (const Triangle& triangle : triangles) {
            const auto [least, most] = std::minmax_element(triangle.begin(), triangle.end());
            low = std::min(low, *least);
            high = std::max(high, *most);
        }
        std::vector<std::uint32_t> known(high - low + 1, kNoVertex);
        indices.reserve(3 * triangles.size());
        for (const Triangle& triangle : triangles) {
            for (const std::uint32_t vertex : triangle) indices.push_back(numberOf(mesh, vertex, known[vertex - low]));
        }
        raise(mesh);
    }

private:
    /// Moves the vertices along the normal where the appearances pass into each other. The simplification knows only
    /// distances: so it keeps the colour of a smooth surface as it keeps the form of a curved one.
    void raise(const ShadingMesh& mesh) {
        constexpr float kHeight = 0.25F;  // mm from one appearance to the other
        std::vector<float> blends(vertices.size());
        std::ranges::transform(vertices, blends.begin(),
                               [&](std::uint32_t vertex) { return blendOf(mesh.vertices[vertex].appearances); });
        const auto [least, most] = std::ranges::minmax(blends);
        if (least == most) return;
        const std::vector<Vec3f> normals = normalsByPlace();
        const float middle = (least + most) / 2;
        for (std::size_t i = 0; i < vertices.size(); ++i) positions[i] += kHeight * (blends[i] - middle) * normals[i];
    }

    /// Unit normals, the same for all vertices at one place: the surface stays in one piece.
    [[nodiscard]] std::vector<Vec3f> normalsByPlace() const {
        std::vector<std::uint32_t> place(vertices.size());
        meshopt_generateVertexRemap(place.data(), indices.data(), indices.size(), positions.data(), positions.size(),
                                    sizeof(Vec3f));
        std::vector<Vec3f> sums(vertices.size(), Vec3f::Zero());
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            const Vec3f& corner = positions[indices[i]];
            const Vec3f area = (positions[indices[i + 1]] - corner).cross(positions[indices[i + 2]] - corner);
            for (std::size_t c = 0; c < 3; ++c) sums[place[indices[i + c]]] += area;
        }
        std::vector<Vec3f> normals(vertices.size());
        for (std::size_t i = 0; i < vertices.size(); ++i) normals[i] = sums[place[i]].normalized();
        return normals;
    }

    std::uint32_t numberOf(const ShadingMesh& mesh, std::uint32_t vertex, std::uint32_t& known) {
        if (known == kNoVertex) {
            known = static_cast<std::uint32_t>(vertices.size());
            vertices.push_back(vertex);
            positions.emplace_back(mesh.vertices[vertex].position.data());
        }
        return known;
    }
};

/// Removes half of the triangles of `piece`, if that many can be removed.
Piece halved(const ShadingMesh& mesh, Piece piece) {
    const auto gradual = std::stable_partition(piece.triangles.begin(), piece.triangles.end(),
                                               [&](const Triangle& t) { return !isGradual(mesh, t); });
    piece.isDrawn = false;
    if (gradual == piece.triangles.end()) return piece;
    const LocalMesh local(mesh, {gradual, piece.triangles.end()});
    const float* positions = local.positions.front().data();
    std::vector<std::uint32_t> left(local.indices.size());
    float error = 0;
    left.resize(meshopt_simplify(left.data(), local.indices.data(), left.size(), positions, local.positions.size(),
                                 sizeof(Vec3f), left.size() / 6 * 3, std::numeric_limits<float>::max(),
                                 meshopt_SimplifyLockBorder, &error));
    const auto fixed = static_cast<std::size_t>(gradual - piece.triangles.begin());
    const std::size_t triangles = fixed + left.size() / 3;
    if (static_cast<double>(triangles) > kWorthwhile * static_cast<double>(piece.triangles.size())) return piece;
    piece.triangles.resize(fixed);
    for (std::size_t i = 0; i < left.size(); i += 3) {
        piece.triangles.push_back({local.vertices[left[i]], local.vertices[left[i + 1]], local.vertices[left[i + 2]]});
    }
    piece.error += error * meshopt_simplifyScale(positions, local.positions.size(), sizeof(Vec3f));
    piece.isDrawn = true;
    return piece;
}

Piece joined(std::span<const Piece> pieces) {
    Piece all;
    for (const Piece& piece : pieces) {
        all.triangles.insert(all.triangles.end(), piece.triangles.begin(), piece.triangles.end());
        all.error = std::max(all.error, piece.error);
    }
    return all;
}

/// The children of piece `i` of the next layer.
std::span<const Piece> childrenOf(const std::vector<Piece>& layer, std::size_t i) {
    return std::span(layer).subspan(2 * i, std::min<std::size_t>(2, layer.size() - 2 * i));
}

void setBall(LodNode& node, const ShadingMesh& mesh, std::span<const Triangle> triangles) {
    Eigen::AlignedBox3f box;
    for (const Triangle& triangle : triangles) {
        for (const std::uint32_t vertex : triangle) box.extend(Vec3f(mesh.vertices[vertex].position.data()));
    }
    node.centre = box.center();
    node.radius = 0.5F * box.diagonal().norm();
}

LodNode parentNode(LodTree& tree, const ShadingMesh& mesh, const Piece& piece) {
    LodNode node;
    setBall(node, mesh, piece.triangles);
    node.error = piece.isDrawn ? piece.error : kNotDrawn;
    if (!piece.isDrawn) return node;
    node.clusters.first = static_cast<std::uint32_t>(tree.clusters.size());
    const auto first = static_cast<std::uint32_t>(tree.triangles.size());
    tree.triangles.insert(tree.triangles.end(), piece.triangles.begin(), piece.triangles.end());
    appendClusters(mesh.vertices, tree.triangles, first, tree.clusters);
    node.clusters.count = static_cast<std::uint32_t>(tree.clusters.size()) - node.clusters.first;
    return node;
}

/// The true surface in pieces: adds them to `tree` as nodes and returns them as the first layer.
std::vector<Piece> trueLayer(LodTree& tree, const ShadingMesh& mesh) {
    std::vector<Piece> layer;
    constexpr std::uint32_t kClusters = kTrianglesPerLeaf / kTrianglesPerCluster;
    static_assert(kTrianglesPerLeaf % kTrianglesPerCluster == 0);
    for (std::size_t first = 0; first < mesh.triangles.size(); first += kTrianglesPerLeaf) {
        const std::size_t count = std::min<std::size_t>(kTrianglesPerLeaf, mesh.triangles.size() - first);
        const auto triangles = std::span(mesh.triangles).subspan(first, count);
        LodNode node;
        setBall(node, mesh, triangles);
        node.clusters.first = static_cast<std::uint32_t>(tree.nodes.size()) * kClusters;
        node.clusters.count = static_cast<std::uint32_t>((count + kTrianglesPerCluster - 1) / kTrianglesPerCluster);
        tree.nodes.push_back(node);
        layer.push_back({{triangles.begin(), triangles.end()}, 0, true});
    }
    return layer;
}

/// The layer above `layer`, whose nodes are the last ones of `tree`.
std::vector<Piece> nextLayer(LodTree& tree, const ShadingMesh& mesh, const std::vector<Piece>& layer) {
    std::vector<Piece> next((layer.size() + 1) / 2);
    parallelFor(next.size(), [&](std::size_t i) { next[i] = halved(mesh, joined(childrenOf(layer, i))); });
    const std::size_t firstBelow = tree.nodes.size() - layer.size();
    for (std::size_t i = 0; i < next.size(); ++i) {
        LodNode node = parentNode(tree, mesh, next[i]);
        node.firstChild = static_cast<std::uint32_t>(firstBelow + 2 * i);
        node.children = static_cast<std::uint32_t>(childrenOf(layer, i).size());
        tree.nodes.push_back(node);
    }
    return next;
}

void addRuns(const ClusterCuller& culler, const LodTree& tree, const std::vector<bool>& mustRefine, std::size_t number,
             std::vector<TriangleRange>& ranges) {
    const LodNode& node = tree.nodes[number];
    const bool isFine = node.error < culler.allowedError(node.centre, node.radius);
    if (node.children == 0 || (isFine && (mustRefine.empty() || !mustRefine[number]))) {
        visibleRanges(culler, std::span(tree.clusters).subspan(node.clusters.first, node.clusters.count), ranges);
        return;
    }
    for (std::size_t i = 0; i < node.children; ++i) addRuns(culler, tree, mustRefine, node.firstChild + i, ranges);
}

}  // namespace

LodTree buildLodTree(const ShadingMesh& mesh) {
    LodTree tree{mesh.triangles, mesh.clusters, {}};
    std::vector<Piece> layer = trueLayer(tree, mesh);
    while (layer.size() > 1 || (layer.front().isDrawn && layer.front().triangles.size() > kFewestTriangles)) {
        layer = nextLayer(tree, mesh, layer);
    }
    return tree;
}

void visibleRanges(const ClusterCuller& culler, const LodTree& tree, const std::vector<bool>& mustRefine,
                   std::vector<TriangleRange>& ranges) {
    addRuns(culler, tree, mustRefine, tree.nodes.size() - 1, ranges);
}

}  // namespace tactooth
