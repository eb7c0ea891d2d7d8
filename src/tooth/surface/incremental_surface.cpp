// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/incremental_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/mesh/mesh_edges.h"
#include "geometry/mesh/vertex_welder.h"
#include "geometry/util/assert.h"
#include "geometry/util/index_bitset.h"
#include "geometry/util/parallel_for.h"
#include "tooth/surface/base_clipper.h"
#include "tooth/surface/box_query.h"
#include "tooth/surface/removed_rows.h"

// Own method. After a carve, only the bricks around the change get a new wall, only base triangles near these walls are
// clipped again, and only the patches that differ are replaced. The snapshots share everything else.

namespace tactooth {
namespace {

Box3 triangleBox(const TriangleMesh& mesh, std::uint32_t t) {
    Box3 box(mesh.corner(t, 0));
    box.extend(mesh.corner(t, 1));
    box.extend(mesh.corner(t, 2));
    return box;
}

Box3 grown(const Box3& box, double margin) {
    return {box.min() - Vec3::Constant(margin), box.max() + Vec3::Constant(margin)};
}

// Voxels. A wall triangle lies within 1 of its lattice edge (kWallReach), and the edge ends one node further on. The
// nodes in this range around a triangle tell whether a wall may touch it.
constexpr float kNodesBefore = 1.5F;
constexpr float kNodesBeyond = 3.0F;

/// Six times the contribution of a triangle to the volume of its body (divergence theorem).
double sixfoldOf(const TriangleMesh& mesh, std::uint32_t t) {
    return mesh.corner(t, 0).dot(mesh.corner(t, 1).cross(mesh.corner(t, 2)));
}

bool isPartlyAdjacent(const SurfacePart& part) { return part.firstAdjacent() < part.mesh().triangles.size(); }

double sixfoldAdjacent(const SurfacePart& part) {
    double sum = 0;
    for (std::uint32_t t = part.firstAdjacent(); t < part.mesh().triangles.size(); ++t)
        sum += sixfoldOf(part.mesh(), t);
    return sum;
}

/// Whether each edge is used as often in one direction as in the other. Equal points count as one vertex.
[[maybe_unused]] bool isClosed(TriangleMesh mesh) {
    std::vector<std::uint32_t> pointOf(mesh.vertices.size());
    VertexWelder welder(mesh.vertices.size());
    welder.addAll(mesh.vertices, pointOf.data());
    for (Triangle& triangle : mesh.triangles) {
        for (std::uint32_t& corner : triangle) corner = pointOf[corner];
    }
    mesh.vertices = welder.takeVertices();
    return edgeBalance(mesh).closed();
}

/// The largest int that is not above `value`.
int roundedDown(float value) {
    TACTOOTH_ASSERT(std::abs(value) < 1e6F);
    const int whole = static_cast<int>(value);
    return whole - static_cast<int>(value < static_cast<float>(whole));
}

/// A box that holds all triangles of a brick's wall.
Box3 wallBox(const Lattice& lattice, const BrickKey& key) {
    const Vec3 low = lattice.corner(key);
    const Box3 nodes(low, low + Vec3::Constant((kBrickSide - 1) * lattice.spacing()));
    return grown(nodes, kWallReach * lattice.spacing());
}

}  // namespace

IncrementalSurface::IncrementalSurface(const CutVolume& volume, std::uint64_t revision)
    : base_(volume.tooth()->outer()),
      closed_(volume.tooth()->isClosed()),
      lattice_(volume.lattice()),
      marginSegments_(base_->mesh().triangles.size()),
      maskedBvh_(base_->tree()) {
    snapshot_ = std::make_shared<const Surface>(uncut(revision));
}

Surface IncrementalSurface::uncut(std::uint64_t revision) const { return {base_, nullptr, {}, revision, closed_}; }

void IncrementalSurface::reset() {
    cells_.clear();
    patchKeys_.clear();
    patches_.clear();
    std::ranges::fill(marginSegments_, std::uint32_t{0});
    hidden_.clear();
    maskedBvh_.showAll();
    sixfoldAdjacent_ = 0;
    adjacentPatches_ = 0;
    failures_ = 0;
    snapshot_ = std::make_shared<const Surface>(uncut(snapshot_->revision + 1));
}

void IncrementalSurface::update(const CutVolume& volume, const std::vector<ChangedBrick>& changed) {
    TACTOOTH_ASSERT(volume.tooth()->outer() == base_);
    TACTOOTH_ASSERT(volume.lattice().spacing() == lattice_.spacing());
    if (changed.empty()) return;
    onlyGrows_ = std::exchange(restorationsSeen_, volume.restorations()) == volume.restorations();
    if (!onlyGrows_) {  // an undo or redo may bring back triangles that a bur has passed
        for (auto& [key, cell] : cells_) cell.knowsBase = false;
    }
    const std::vector<BrickKey> keys = bricksToExtract(volume, changed);
    std::vector<Cell*> cells;
    for (const BrickKey& key : keys) cells.push_back(&cells_[key]);
    countMargin(cells, ~0U);
    parallelFor(keys.size(), [&](std::size_t i) { extract(volume, keys[i], *cells[i]); });
    countMargin(cells, 1);

    std::vector<BrickKey> dirty;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        failures_ += static_cast<std::size_t>(cells[i]->wall.failures);
        if (cells[i]->isNew) dirty.push_back(keys[i]);
    }
    const std::vector<std::uint32_t> triangles = affectedBase(cells);
    storeBase(triangles, clipBase(volume, triangles, cutLines(triangles)), dirty);
    publish(dirty);
}

/// A change next to the faces of a brick also moves the walls of the neighbouring bricks.
std::vector<BrickKey> IncrementalSurface::bricksToExtract(const CutVolume& volume,
                                                          const std::vector<ChangedBrick>& changed) const {
    std::vector<BrickKey> keys;
    for (const ChangedBrick& brick : changed) {
        brick.forEachAffected([&](int i) { keys.push_back(brick.key.neighbour(i)); });
    }
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    std::erase_if(keys, [&](const BrickKey& key) { return volume.bricks().find(key) == nullptr; });
    return keys;
}

void IncrementalSurface::extract(const CutVolume& volume, const BrickKey& key, Cell& cell) const {
    if (!cell.knowsBase) {
        const Box3 box = wallBox(lattice_, key);
        const std::vector<std::uint32_t> near = trianglesTouching(*base_, box);
        cell.base.clear();
        for (const std::uint32_t t : near) cell.base.push_back(boxed(t));
        cell.bodies = bodiesIn(*base_, near, box.center());
        cell.knowsBase = true;
    }
    const BrickNeighbourhood nodes(volume.bricks(), key, lattice_.spacing());
    CavityWall wall = extractWall(nodes, lattice_, key);
    cell.margin = findMargin(wall, base_->mesh(), findAffected(nodes, key, cell));
    WallPatch patch = clipWall(std::move(wall), cell.margin, *base_);
    cell.isNew = !patch.isIdentical(cell.wall);
    cell.wall = std::move(patch);
}

IncrementalSurface::TriangleBounds IncrementalSurface::boxed(std::uint32_t triangle) const {
    TACTOOTH_ASSERT(triangle < base_->mesh().triangles.size());
    const auto& [a, b, c] = base_->mesh().triangles[triangle];
    const auto& vertices = base_->mesh().vertices;
    return {triangle, vertices[a].cwiseMin(vertices[b]).cwiseMin(vertices[c]),
            vertices[a].cwiseMax(vertices[b]).cwiseMax(vertices[c])};
}

/// Returns the base triangles that a wall may touch. A triangle whose nodes are all removed is reported as affected
/// once more and then forgotten: its nodes stay removed, so that no wall comes near it again.
std::vector<std::uint32_t> IncrementalSurface::findAffected(const BrickNeighbourhood& nodes, const BrickKey& key,
                                                            Cell& cell) const {
    using Coverage = RemovedRows::Coverage;
    std::vector<std::uint32_t> nearWall;
    cell.affected.clear();
    if (!nodes.hasRemoved() && onlyGrows_) return nearWall;
    const RemovedRows rows(nodes);
    nearWall.reserve(cell.base.size());
    const Vec3f corner = lattice_.corner(key).cast<float>();
    const auto voxels = static_cast<float>(1 / lattice_.spacing());
    const auto place = [&](const Vec3f& point, float beyond) {
        BrickNeighbourhood::Place at;
        for (int axis = 0; axis < 3; ++axis) {
            const float exact = (point[axis] - corner[axis]) * voxels + beyond;
            // The neighbourhood ends here. Clamping also keeps far places within the range of an int.
            at[axis] = roundedDown(std::clamp(exact, -1.0F, static_cast<float>(kBrickSide)));
        }
        return at;
    };
    std::erase_if(cell.base, [&](const TriangleBounds& base) {
        const Coverage coverage = rows.coverage(place(base.low, -kNodesBefore), place(base.high, kNodesBeyond));
        if (coverage != Coverage::None || !onlyGrows_) cell.affected.push_back(base.triangle);
        if (coverage == Coverage::Some) nearWall.push_back(base.triangle);
        return coverage == Coverage::All;
    });
    return nearWall;
}

std::vector<std::uint32_t> IncrementalSurface::affectedBase(const std::vector<Cell*>& cells) const {
    IndexBitset triangles(base_->mesh().triangles.size());
    for (const Cell* cell : cells) {
        for (const std::uint32_t triangle : cell->affected) triangles.add(triangle);
    }
    return triangles.sorted();
}

void IncrementalSurface::countMargin(const std::vector<Cell*>& cells, std::uint32_t step) {
    for (const Cell* cell : cells) {
        for (const MarginSegment& piece : cell->margin) {
            TACTOOTH_ASSERT(step == 1 || marginSegments_[piece.base] > 0);
            marginSegments_[piece.base] += step;
        }
    }
}

std::vector<const MarginSegment*> IncrementalSurface::marginOf(std::uint32_t triangle) const {
    std::vector<const MarginSegment*> pieces;
    TACTOOTH_ASSERT(triangle < marginSegments_.size());
    if (marginSegments_[triangle] == 0) return pieces;
    const Box3 box = grown(triangleBox(base_->mesh(), triangle), kWallReach * lattice_.spacing());
    for (const BrickKey& key : lattice_.bricksTouching(box)) {
        const auto cell = cells_.find(key);
        if (cell == cells_.end()) continue;
        const auto& margin = cell->second.margin;
        auto piece = std::lower_bound(margin.begin(), margin.end(), triangle,
                                      [](const MarginSegment& a, std::uint32_t t) { return a.base < t; });
        for (; piece != margin.end() && piece->base == triangle; ++piece) pieces.push_back(&*piece);
    }
    TACTOOTH_ASSERT(pieces.size() == marginSegments_[triangle]);
    return pieces;
}

std::vector<std::vector<ClipSegment>> IncrementalSurface::cutLines(const std::vector<std::uint32_t>& triangles) const {
    std::vector<std::vector<ClipSegment>> segments(triangles.size());
    parallelFor(triangles.size(), [&](std::size_t i) { segments[i] = segmentsOnBase(marginOf(triangles[i])); });
    return segments;
}

/// Returns whether this changes anything.
bool IncrementalSurface::setRemains(const BrickKey& home, std::uint32_t triangle, Remains pieces) {
    const auto cell = cells_.find(home);
    if (pieces.empty()) return cell != cells_.end() && cell->second.remains.erase(triangle) > 0;
    Remains& kept = (cell != cells_.end() ? cell->second : cells_[home]).remains[triangle];
    if (kept == pieces) return false;
    kept = std::move(pieces);
    return true;
}

void IncrementalSurface::storeBase(const std::vector<std::uint32_t>& triangles,
                                   std::vector<ClippedBaseTriangle> results, std::vector<BrickKey>& dirty) {
    const TriangleMesh& mesh = base_->mesh();
    TACTOOTH_ASSERT(results.size() == triangles.size());
    if (hidden_.empty()) hidden_.assign((mesh.triangles.size() + 63) / 64, 0);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const std::uint32_t t = triangles[i];
        TACTOOTH_ASSERT(results[i].hidden || results[i].pieces.empty());
        const std::uint64_t bit = std::uint64_t{1} << (t % 64);
        if (base_->isAdjacent(t) && results[i].hidden != isHidden(hidden_, t))
            sixfoldAdjacent_ += (results[i].hidden ? -1 : 1) * sixfoldOf(mesh, t);
        hidden_[t / 64] = results[i].hidden ? hidden_[t / 64] | bit : hidden_[t / 64] & ~bit;
        maskedBvh_.setHidden(t, results[i].hidden);
        failures_ += results[i].failed;
        const BrickKey home = lattice_.brickAt((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3);
        if (setRemains(home, t, std::move(results[i].pieces))) dirty.push_back(home);
    }
    std::sort(dirty.begin(), dirty.end());
    dirty.erase(std::unique(dirty.begin(), dirty.end()), dirty.end());
}

/// The patch of a brick: its wall, then what remains of base triangles. Null if there is nothing.
std::shared_ptr<const SurfacePart> IncrementalSurface::patchOf(const Cell& cell) const {
    std::size_t remaining = 0;
    for (const auto& [triangle, remains] : cell.remains) remaining += remains.size();
    if (cell.wall.mesh.empty() && remaining == 0) return nullptr;
    TaggedMesh patch;
    auto& [mesh, tags] = patch;
    const auto startWith = [](auto& to, const auto& from, std::size_t more) {
        to.reserve(from.size() + more);
        to.assign(from.begin(), from.end());
    };
    startWith(mesh.vertices, cell.wall.mesh.vertices, 3 * remaining);
    startWith(mesh.triangles, cell.wall.mesh.triangles, remaining);
    startWith(tags, cell.wall.tags, remaining);
    for (const auto& [triangle, remains] : cell.remains) {
        for (const std::array<Vec3f, 3>& corners : remains) {
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
            mesh.triangles.push_back({first, first + 1, first + 2});
            tags.push_back(base_->tag(triangle));
        }
    }
    TACTOOTH_ASSERT(tags.size() == mesh.triangles.size());
    return patchPart(std::move(patch), cell.bodies, *base_);
}

void IncrementalSurface::setPatch(const BrickKey& key, std::shared_ptr<const SurfacePart> patch) {
    TACTOOTH_ASSERT(patchKeys_.size() == patches_.size());
    const auto place = std::lower_bound(patchKeys_.begin(), patchKeys_.end(), key);
    const auto part = patches_.begin() + (place - patchKeys_.begin());
    const bool isKnown = place != patchKeys_.end() && *place == key;
    if (isKnown && isPartlyAdjacent(**part)) --adjacentPatches_, sixfoldAdjacent_ -= sixfoldAdjacent(**part);
    TACTOOTH_ASSERT(adjacentPatches_ <= patches_.size());
    if (patch && isPartlyAdjacent(*patch)) ++adjacentPatches_, sixfoldAdjacent_ += sixfoldAdjacent(*patch);
    if (patch && isKnown) {
        *part = std::move(patch);
    } else if (patch) {
        patchKeys_.insert(place, key);
        patches_.insert(part, std::move(patch));
    } else if (isKnown) {
        patchKeys_.erase(place);
        patches_.erase(part);
    }
}

void IncrementalSurface::publish(const std::vector<BrickKey>& dirty) {
    std::vector<std::shared_ptr<const SurfacePart>> parts(dirty.size());
    parallelFor(dirty.size(), [&](std::size_t i) { parts[i] = patchOf(cells_.at(dirty[i])); });
    for (std::size_t i = 0; i < dirty.size(); ++i) setPatch(dirty[i], std::move(parts[i]));
    Surface surface = uncut(snapshot_->revision + 1);
    surface.hidden = std::make_shared<const TriangleMask>(hidden_);
    surface.maskedTree = std::make_shared<const AabbTree>(maskedBvh_.maskedTree());
    surface.patches = patches_;
    snapshot_ = std::make_shared<const Surface>(std::move(surface));
}

double IncrementalSurface::lostAdjacent() const {
    return adjacentPatches_ > 0 ? std::max(0.0, -sixfoldAdjacent_ / 6) : 0;
}

void IncrementalSurface::validateCell(const BrickKey& key, const Cell& cell) const {
    TACTOOTH_ASSERT(key.isInRange());
    TACTOOTH_ASSERT(std::ranges::is_sorted(cell.margin, [](const MarginSegment& a, const MarginSegment& b) {
        return a.base != b.base ? a.base < b.base : a.wall < b.wall;
    }));
    TACTOOTH_ASSERT(cell.wall.tags.size() == cell.wall.mesh.triangles.size());
    for (const Triangle& triangle : cell.wall.mesh.triangles) {
        for (const std::uint32_t corner : triangle) TACTOOTH_ASSERT(corner < cell.wall.mesh.vertices.size());
    }
    std::size_t triangles = cell.wall.mesh.triangles.size();
    for (const auto& [triangle, remains] : cell.remains) {
        TACTOOTH_ASSERT(!remains.empty());
        TACTOOTH_ASSERT(isHidden(hidden_, triangle));
        triangles += remains.size();
    }
    const auto place = std::ranges::lower_bound(patchKeys_, key);
    const bool hasPatch = place != patchKeys_.end() && *place == key;
    TACTOOTH_ASSERT(hasPatch == (triangles > 0));
    if (!hasPatch) return;
    const SurfacePart& patch = *patches_[static_cast<std::size_t>(place - patchKeys_.begin())];
    TACTOOTH_ASSERT(patch.mesh().triangles.size() == triangles);
}

void IncrementalSurface::validateMask() const {
    const std::size_t count = base_->mesh().triangles.size();
    TACTOOTH_ASSERT(hidden_.empty() || hidden_.size() == (count + 63) / 64);
    for (std::size_t t = count; t < 64 * hidden_.size(); ++t)
        TACTOOTH_ASSERT(!isHidden(hidden_, static_cast<std::uint32_t>(t)));
    TACTOOTH_ASSERT(snapshot_->hidden == nullptr ? hidden_.empty() : *snapshot_->hidden == hidden_);
    TACTOOTH_ASSERT((snapshot_->hidden == nullptr) == (snapshot_->maskedTree == nullptr));
}

void IncrementalSurface::validate() const {
    TACTOOTH_ASSERT(patchKeys_.size() == patches_.size());
    TACTOOTH_ASSERT(std::ranges::is_sorted(patchKeys_));
    TACTOOTH_ASSERT(std::ranges::adjacent_find(patchKeys_) == patchKeys_.end());
    std::vector<std::uint32_t> segments(marginSegments_.size());
    for (const auto& [key, cell] : cells_) {
        validateCell(key, cell);
        for (const MarginSegment& piece : cell.margin) ++segments[piece.base];
    }
    TACTOOTH_ASSERT(segments == marginSegments_);
    for (const BrickKey& key : patchKeys_) TACTOOTH_ASSERT(cells_.contains(key));
    std::size_t adjacent = 0;
    for (const auto& patch : patches_) {
        TACTOOTH_ASSERT(patch != nullptr);
        adjacent += isPartlyAdjacent(*patch) ? 1 : 0;
    }
    TACTOOTH_ASSERT(adjacent == adjacentPatches_);
    validateMask();
    TACTOOTH_ASSERT(snapshot_->base == base_);
    TACTOOTH_ASSERT(snapshot_->patches == patches_);
    if (failures_ == 0) TACTOOTH_ASSERT(isClosed(visibleMesh(*snapshot_).mesh));
}

}  // namespace tactooth
