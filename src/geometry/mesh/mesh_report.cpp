// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/mesh_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/mesh/mesh_edges.h"
#include "geometry/util/assert.h"
#include "geometry/util/disjoint_sets.h"

namespace tactooth {
namespace {

/// A triangle lower than this share of its longest side is flat: rounding its corners to floats (23 binary digits)
/// moves them by as much.
constexpr double kFlatRatio = 1.0 / (1 << 23);

std::uint32_t cornerNumber(std::size_t triangle, std::size_t corner) {
    return static_cast<std::uint32_t>(3 * triangle + corner % 3);
}

/// The corner where the side that begins at `corner` ends.
std::uint32_t sideEnd(std::uint32_t corner) { return cornerNumber(corner / 3, corner % 3 + 1); }

/// Fills the results that follow from edges. Joins in `fans` the corners of adjacent triangles around a vertex.
void countEdges(const TriangleMesh& mesh, MeshReport& report, DisjointSets& fans, DisjointSets& shells) {
    std::int64_t edges = 0;
    MeshEdges(mesh).forEachEdge([&](std::span<const EdgeUse> uses) {
        ++edges;
        report.boundaryEdges += uses.size() == 1;
        const bool isOdd = uses.size() % 2 != 0;
        report.nonManifoldEdges += uses.size() > 2;
        report.oddEdges += uses.size() > 2 && isOdd;
        const auto upward = static_cast<std::size_t>(std::ranges::count(uses, true, &EdgeUse::upward));
        report.inconsistentEdges += !isOdd && 2 * upward != uses.size();
        for (const EdgeUse& use : uses.subspan(1)) {
            const bool sameWay = use.upward == uses[0].upward;
            fans.join(uses[0].corner, sameWay ? use.corner : sideEnd(use.corner));
            fans.join(sideEnd(uses[0].corner), sameWay ? sideEnd(use.corner) : use.corner);
            shells.join(uses[0].corner / 3, use.corner / 3);
        }
    });
    report.eulerCharacteristic -= edges;
}

/// Counts vertices, pinched vertices and, for Euler's formula, the fans of triangles around vertices.
void countVertices(const TriangleMesh& mesh, MeshReport& report, DisjointSets& fans) {
    std::vector<std::uint8_t> fansOfVertex(mesh.vertices.size(), 0);  // 0, 1, or 2 for more
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        if (isDegenerate(mesh.triangles[triangle])) continue;
        ++report.eulerCharacteristic;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t number = cornerNumber(triangle, corner);
            if (fans.find(number) != number) continue;
            ++report.eulerCharacteristic;
            std::uint8_t& count = fansOfVertex[mesh.triangles[triangle][corner]];
            count = static_cast<std::uint8_t>(std::min(count + 1, 2));
        }
    }
    for (const std::uint8_t count : fansOfVertex) {
        report.vertices += count > 0;
        report.pinchedVertices += count > 1;
    }
}

/// Whether the triangle with the corners `a`, `b`, `c` and twice the area `doubleArea` is flat.
bool isFlat(const Vec3& a, const Vec3& b, const Vec3& c, double doubleArea) {
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return doubleArea <= kFlatRatio * longest;
}

/// Fills areas, volumes and shells. Volumes are measured from the middle of the box, where the rounding error is
/// smallest.
void measure(const TriangleMesh& mesh, MeshReport& report, DisjointSets& shells) {
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> shellOf(mesh.triangles.size(), kNone);  // by the first triangle of a shell
    const Vec3 middle = report.box.isEmpty() ? Vec3::Zero() : Vec3(report.box.center());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        if (isDegenerate(mesh.triangles[triangle])) continue;
        std::uint32_t& number = shellOf[shells.find(static_cast<std::uint32_t>(triangle))];
        if (number == kNone) {
            number = static_cast<std::uint32_t>(report.shells.size());
            report.shells.emplace_back();
        }
        const Vec3 a = mesh.corner(triangle, 0) - middle;
        const Vec3 b = mesh.corner(triangle, 1) - middle;
        const Vec3 c = mesh.corner(triangle, 2) - middle;
        const Vec3 areaVector = (b - a).cross(c - a);
        report.area += areaVector.norm() / 2;
        report.flatTriangles += isFlat(a, b, c, areaVector.norm());
        ShellReport& shell = report.shells[number];
        ++shell.triangles;
        shell.signedVolume += a.dot(areaVector) / 6;
        shell.box.extend(a + middle).extend(b + middle).extend(c + middle);
    }
    for (const ShellReport& shell : report.shells) report.signedVolume += shell.signedVolume;
    std::stable_sort(report.shells.begin(), report.shells.end(),
                     [](const ShellReport& a, const ShellReport& b) { return a.triangles > b.triangles; });
}

/// The number of triangles whose three corners are those of an earlier one.
std::size_t countDuplicates(const TriangleMesh& mesh) {
    std::vector<std::size_t> first(mesh.vertices.size() + 1, 0);
    for (const Triangle& triangle : mesh.triangles) ++first[*std::min_element(triangle.begin(), triangle.end())];
    std::exclusive_scan(first.begin(), first.end(), first.begin(), std::size_t{0});
    std::vector<std::array<std::uint32_t, 2>> others(first.back());  // the two larger corners, grouped by the smallest
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (Triangle triangle : mesh.triangles) {
        std::sort(triangle.begin(), triangle.end());
        others[next[triangle[0]]++] = {triangle[1], triangle[2]};
    }
    std::size_t duplicates = 0;
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
        const auto begin = others.begin() + static_cast<std::ptrdiff_t>(first[vertex]);
        const auto end = others.begin() + static_cast<std::ptrdiff_t>(first[vertex + 1]);
        std::sort(begin, end);
        for (auto pair = begin; pair != end; ++pair) {
            const bool proper = (*pair)[0] != (*pair)[1] && (*pair)[0] != vertex;
            duplicates += proper && pair != begin && *pair == *(pair - 1);
        }
    }
    return duplicates;
}

}  // namespace

std::optional<double> MeshReport::volume() const {
    return watertight() ? std::optional(std::abs(signedVolume)) : std::nullopt;
}

std::optional<std::int64_t> MeshReport::genus() const {
    if (!watertight() || nonManifoldEdges > 0) return std::nullopt;
    TACTOOTH_ASSERT(eulerCharacteristic % 2 == 0);
    return static_cast<std::int64_t>(shells.size()) - eulerCharacteristic / 2;
}

MeshReport reportOn(const TriangleMesh& mesh) {
    MeshReport report;
    report.triangles = mesh.triangles.size();
    report.box = boundingBox(mesh);
    report.degenerateTriangles =
        static_cast<std::size_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), isDegenerate));
    report.duplicateTriangles = countDuplicates(mesh);
    DisjointSets fans(3 * mesh.triangles.size());
    DisjointSets shells(mesh.triangles.size());
    countEdges(mesh, report, fans, shells);
    countVertices(mesh, report, fans);
    measure(mesh, report, shells);
    TACTOOTH_ASSERT(report.area >= 0 || !std::isfinite(report.area));
    TACTOOTH_ASSERT(report.vertices <= mesh.vertices.size());
    return report;
}

}  // namespace tactooth
