// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/shells.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "collision/solid/winding.h"
#include "geometry/mesh/mesh_edges.h"
#include "geometry/util/assert.h"

// Orientation by propagation over edges, and of each component by ray parity: K. Takayama, A. Jacobson, L. Kavan, O.
// Sorkine-Hornung, "A Simple Method for Correcting Facet Orientations in Polygon Meshes Based on Ray Casting", J.
// Computer Graphics Techniques 3(4), 2014. Differs from the paper: one ray from each of a few large triangles decides,
// by the parity of its crossings; components that cross each other are decided by their volume.

namespace tactooth {
namespace {

/// Rays that decide about a shell: more than one, since a shell may barely cross another one.
constexpr std::size_t kVotes = 9;

/// A triangle that shares an edge.
struct Neighbour {
    std::uint32_t other;
    bool agrees;  // both triangles have the same outside
};

/// The neighbours of each triangle over edges of exactly two triangles.
class Neighbours {
public:
    explicit Neighbours(const TriangleMesh& mesh) : of_(mesh.triangles.size()), count_(mesh.triangles.size(), 0) {
        MeshEdges(mesh).forEachEdge([&](std::span<const EdgeUse> uses) {
            if (uses.size() != 2) return;
            const std::uint32_t a = uses[0].corner / 3, b = uses[1].corner / 3;
            TACTOOTH_ASSERT(a < of_.size() && b < of_.size());
            TACTOOTH_ASSERT(count_[a] < 3 && count_[b] < 3);
            const bool agrees = uses[0].upward != uses[1].upward;
            of_[a][count_[a]++] = {b, agrees};
            of_[b][count_[b]++] = {a, agrees};
        });
    }
    [[nodiscard]] std::span<const Neighbour> of(std::uint32_t triangle) const {
        TACTOOTH_ASSERT(triangle < of_.size());
        return {of_[triangle].data(), count_[triangle]};
    }

private:
    std::vector<std::array<Neighbour, 3>> of_;
    std::vector<std::uint8_t> count_;
};

struct Shell {
    std::vector<std::uint32_t> triangles;
    bool isNonOrientable = false;
    bool crosses = false;
    bool isInward = false;  // once the triangles that disagree with the first one are flipped
};

/// Collects the shell of a triangle. Marks in `turned` the triangles that disagree with the first one.
Shell gather(std::uint32_t first, const Neighbours& neighbours, std::vector<std::uint8_t>& reached,
             std::vector<std::uint8_t>& turned) {
    Shell shell;
    shell.triangles.push_back(first);
    reached[first] = 1;
    for (std::size_t i = 0; i < shell.triangles.size(); ++i) {
        const std::uint32_t here = shell.triangles[i];
        for (const auto& [other, agrees] : neighbours.of(here)) {
            const auto wanted = static_cast<std::uint8_t>(agrees ? turned[here] : 1 - turned[here]);
            if (reached[other] != 0) {
                shell.isNonOrientable |= turned[other] != wanted;
                continue;
            }
            reached[other] = 1;
            turned[other] = wanted;
            shell.triangles.push_back(other);
        }
    }
    return shell;
}

/// Whether a shell faces inward, by a vote of its largest triangles.
bool facesInward(const SurfacePart& part, const Shell& shell, const std::vector<std::uint8_t>& turned) {
    std::vector<std::pair<double, std::uint32_t>> largest;
    for (const std::uint32_t t : shell.triangles) largest.emplace_back(-part.mesh().areaVector(t).squaredNorm(), t);
    TACTOOTH_ASSERT(!largest.empty());
    const std::size_t votes = std::min(kVotes, largest.size());
    std::partial_sort(largest.begin(), largest.begin() + static_cast<std::ptrdiff_t>(votes), largest.end());
    int inward = 0;
    for (std::size_t i = 0; i < votes; ++i) {
        const std::uint32_t t = largest[i].second;
        const bool isInsideInFront = windingInFront(part, t) % 2 != 0;
        inward += isInsideInFront != (turned[t] != 0) ? 1 : -1;
    }
    return inward > 0;
}

/// Whether most triangles of a shell disagree with its first one.
bool mostDisagree(const Shell& shell, const std::vector<std::uint8_t>& turned) {
    const auto count = std::ranges::count_if(shell.triangles, [&](std::uint32_t t) { return turned[t] != 0; });
    return 2 * static_cast<std::size_t>(count) > shell.triangles.size();
}

/// The volume of a shell once all its triangles agree with the first one.
double volumeOf(const TriangleMesh& mesh, const Shell& shell, const std::vector<std::uint8_t>& turned,
                const Vec3& middle) {
    double sixfold = 0;
    for (const std::uint32_t t : shell.triangles) {
        const double part =
            (mesh.corner(t, 0) - middle).dot((mesh.corner(t, 1) - middle).cross(mesh.corner(t, 2) - middle));
        sixfold += turned[t] != 0 ? -part : part;
    }
    return sixfold / 6;
}

}  // namespace

ShellOrientation orientShells(const SurfacePart& part, std::span<const std::uint32_t> crossing, TriangleMesh& mesh) {
    TACTOOTH_ASSERT(part.mesh().triangles.size() == mesh.triangles.size());
    const Neighbours neighbours(part.mesh());
    std::vector<std::uint8_t> reached(mesh.triangles.size(), 0), turned(mesh.triangles.size(), 0);
    std::vector<Shell> shells;
    ShellOrientation result;
    std::vector<std::uint8_t> crosses(mesh.triangles.size(), 0);
    for (const std::uint32_t t : crossing) {
        TACTOOTH_ASSERT(t < crosses.size());
        crosses[t] = 1;
    }
    for (std::uint32_t t = 0; t < reached.size(); ++t) {
        if (reached[t] != 0 || isDegenerate(mesh.triangles[t])) continue;
        Shell& shell = shells.emplace_back(gather(t, neighbours, reached, turned));
        shell.crosses = std::ranges::any_of(shell.triangles, [&](std::uint32_t one) { return crosses[one] != 0; });
        result.isNonOrientable |= shell.isNonOrientable;
    }
    result.shells = shells.size();
    if (result.isNonOrientable) return result;
    const Vec3 middle = part.tree().box().center();
    double volumeOfCrossing = 0;
    for (Shell& shell : shells) {
        shell.isInward = shell.crosses ? mostDisagree(shell, turned) : facesInward(part, shell, turned);
        if (shell.crosses) volumeOfCrossing += (shell.isInward ? -1 : 1) * volumeOf(mesh, shell, turned, middle);
    }
    for (Shell& shell : shells) {
        if (shell.crosses && volumeOfCrossing < 0) shell.isInward = !shell.isInward;
        const double volume = (shell.isInward ? -1 : 1) * volumeOf(mesh, shell, turned, middle);
        result.voids += volume < 0;
        result.volume += volume;
        for (const std::uint32_t t : shell.triangles) {
            if ((turned[t] != 0) == shell.isInward) continue;
            std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
            ++result.flippedTriangles;
        }
    }
    TACTOOTH_ASSERT(result.voids <= result.shells);
    TACTOOTH_ASSERT(result.flippedTriangles <= mesh.triangles.size());
    return result;
}

}  // namespace tactooth
