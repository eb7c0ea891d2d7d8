// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/shells.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "collision/solid/winding.h"
#include "geometry/mesh/mesh_edges.h"

namespace tactooth {
namespace {

/// Looks that decide about a shell: more than one, for those that cross another one by a hair.
constexpr std::size_t kVotes = 9;

struct Neighbour {
    std::uint32_t other;
    bool agrees;  // on which side is outside
};

/// Over edges of two triangles.
class Neighbours {
public:
    explicit Neighbours(const TriangleMesh& mesh) : of_(mesh.triangles.size()), count_(mesh.triangles.size(), 0) {
        MeshEdges(mesh).forEachEdge([&](std::span<const EdgeUse> uses) {
            if (uses.size() != 2) return;
            const std::uint32_t a = uses[0].corner / 3, b = uses[1].corner / 3;
            const bool agrees = uses[0].upward != uses[1].upward;
            of_[a][count_[a]++] = {b, agrees};
            of_[b][count_[b]++] = {a, agrees};
        });
    }
    [[nodiscard]] std::span<const Neighbour> of(std::uint32_t triangle) const {
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
    bool isInward = false;  // with those of its triangles turned that disagree with the first one
};

/// Marks in `turned` what disagrees with the first triangle of a shell.
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

/// Whether a shell looks inward, as its largest triangles say.
bool facesInward(const SurfacePart& part, const Shell& shell, const std::vector<std::uint8_t>& turned) {
    std::vector<std::pair<double, std::uint32_t>> largest;
    for (const std::uint32_t t : shell.triangles) largest.emplace_back(-part.mesh().areaVector(t).squaredNorm(), t);
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

/// Of a shell, when all its triangles agree with the first one.
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
    const Neighbours neighbours(part.mesh());
    std::vector<std::uint8_t> reached(mesh.triangles.size(), 0), turned(mesh.triangles.size(), 0);
    std::vector<Shell> shells;
    ShellOrientation result;
    std::vector<std::uint8_t> crosses(mesh.triangles.size(), 0);
    for (const std::uint32_t t : crossing) crosses[t] = 1;
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
        result.hollows += volume < 0;
        result.volume += volume;
        for (const std::uint32_t t : shell.triangles) {
            if ((turned[t] != 0) == shell.isInward) continue;
            std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
            ++result.flippedTriangles;
        }
    }
    return result;
}

}  // namespace tactooth
