// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/hermite_data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "collision/narrow/lane_flags.h"
#include "geometry/util/assert.h"
#include "tooth/volume/brick_sweep.h"

// Keeps the Hermite data of dual contouring (T. Ju, F. Losasso, S. Schaefer, J. Warren, "Dual Contouring of Hermite
// Data", SIGGRAPH 2002): the crossing of the boundary with each lattice edge, and the normal there. Difference: a
// crossing is found on the swept envelope itself, by Newton's method with bisection, and moves outward with each carve.

namespace tactooth {
namespace {

constexpr float kNoBound = std::numeric_limits<float>::infinity();
constexpr float kOnBoundary = 1e-5F;  ///< mm; the error of an envelope's distance to a sweep
/// Share of a lattice edge. The normal is sampled this far outside the boundary. On the line that a sharp rim has
/// swept, the direction of the nearest point is only rounding. A little outside it is the normal of the surface of that
/// line.
constexpr float kNormalOffset = 0.04F;
/// mm. Within this distance one more Newton step ends on the boundary: to 2e-6 mm on a rim rounded to 0.05 mm, and to
/// 1e-4 mm on a sharp one.
constexpr float kLastStep = 2e-4F;
constexpr int kNewtonRounds = 20;  ///< bisects where a Newton step leaves the edge: 50 um / 2^20 at worst
constexpr int kExtensions = 4;     ///< steps of one move that each move the crossing farther along the same edge

/// Eight lattice edges of one block, each from its removed end (place 0) to its solid end (place 1), and the crossings
/// of the boundary with them.
class Edges8 {
public:
    /// Adds an edge. `end`: its removed end, in steps from the block's first node. `direction` (1 or -1) leads to the
    /// solid end. `place` (0..1) and `normal`: the known crossing.
    void add(const std::array<int, 3>& end, int axis, float direction, float place, const Vec3f& normal) {
        TACTOOTH_ASSERT(count_ < 8);
        TACTOOTH_ASSERT(axis >= 0 && axis < 3);
        TACTOOTH_ASSERT(std::abs(direction) == 1);
        TACTOOTH_ASSERT(place >= 0 && place <= 1);
        for (int i = 0; i < 3; ++i) {
            end_[i][count_] = static_cast<float>(end[i]);
            direction_[i][count_] = i == axis ? direction : 0;
            normal_[i][count_] = normal[i];
        }
        place_[count_++] = place;
    }
    [[nodiscard]] float place(int lane) const {
        TACTOOTH_ASSERT(lane >= 0 && lane < count_);
        return place_[lane];
    }
    [[nodiscard]] std::array<OctahedralNormal, 8> normals() const {
        return OctahedralNormal::pack(Vec3x8::load(normal_));
    }

    /// Moves the crossings outward as long as one of the steps contains them.
    void extend(const std::vector<SweepLanes>& steps, double spacing) {
        TACTOOTH_ASSERT(count_ > 0);
        TACTOOTH_ASSERT(spacing > 0);
        fill();
        Float8 lastStep = Float8::all(-1);  // a crossing is no longer inside the step that moved it last
        bool moved = true;
        for (int round = 0; round < kExtensions && moved; ++round) {
            moved = false;
            for (std::size_t i = 0; i < steps.size(); ++i) {
                const Float8 number = Float8::all(static_cast<float>(i));
                const Float8 isOther = isLess(lastStep, number) + isLess(number, lastStep);
                moved |= moveOut(steps[i], number, isOther, lastStep, static_cast<float>(spacing));
            }
        }
    }

private:
    static Float8 sizeOf(Float8 distance) { return max(distance, zero8() - distance); }

    /// Lanes without an edge repeat the first one.
    void fill() {
        for (int lane = count_; lane < 8; ++lane) {
            place_[lane] = place_[0];
            for (int i = 0; i < 3; ++i) {
                end_[i][lane] = end_[i][0];
                direction_[i][lane] = direction_[i][0];
            }
        }
    }

    [[nodiscard]] Vec3x8 at(Float8 place) const {
        const Vec3x8 end = Vec3x8::load(end_);
        const Vec3x8 direction = Vec3x8::load(direction_);
        return {end.x + place * direction.x, end.y + place * direction.y, end.z + place * direction.z};
    }

    /// Moves the crossings inside the region swept by `step` to where their edges leave it. Returns whether one has
    /// moved.
    bool moveOut(const SweepLanes& step, Float8 number, Float8 isOther, Float8& lastStep, float spacing) {
        if (!isAny(isOther)) return false;
        const Float8 start = Float8::load(place_);
        const Float8 onBoundary = Float8::all(-kOnBoundary);
        const Samples8 here = step.sample(at(start), onBoundary);
        Float8 holds = isOther * isLess(here.distance, onBoundary);
        if (!isAny(holds)) return false;
        const Float8 exit = exitOf(step, start, here, holds, spacing);
        holds = holds * isLess(start, exit);
        if (!isAny(holds)) return false;
        const Vec3x8 normal = step.sample(at(exit + Float8::all(kNormalOffset)), Float8::all(kNoBound)).gradient;
        choose(holds, exit, start).store(place_);
        choose(holds, normal, Vec3x8::load(normal_)).store(normal_);
        lastStep = choose(holds, number, lastStep);
        return true;
    }

    /// Where the edges in `searching` leave the region swept by `step`, from `start` outward. `sample` is the sample of
    /// the step at `start`. Newton's method, with bisection of the rest of the edge where a step leaves it.
    [[nodiscard]] Float8 exitOf(const SweepLanes& step, Float8 start, Samples8 sample, Float8 searching,
                                float spacing) const {
        const Vec3x8 direction = Vec3x8::load(direction_);
        Float8 inside = start;
        Float8 outside = one8();
        Float8 place = start;
        for (int round = 0; round < kNewtonRounds && isAny(searching); ++round) {
            const Float8 isLast = isLess(sizeOf(sample.distance), Float8::all(kLastStep));
            const Float8 slope = dot(sample.gradient, direction) * Float8::all(spacing);
            const Float8 newton = place - sample.distance / slope;
            const Float8 isOn = isLess(inside, newton) * isLess(newton, outside);
            const Float8 half = Float8::all(0.5F) * (inside + outside);
            place = choose(searching, choose(isOn, newton, half), place);
            searching = searching * (one8() - isLast * isOn);
            if (!isAny(searching)) break;
            sample = step.sample(at(place), Float8::all(kNoBound));
            const Float8 isInside = searching * isLess(sample.distance, zero8());
            inside = choose(isInside, place, inside);
            outside = choose(searching - isInside, place, outside);
            searching = searching * isLess(Float8::all(kOnBoundary), sizeOf(sample.distance));
        }
        return place;
    }

    int count_ = 0;
    float end_[3][8] = {};
    float direction_[3][8] = {};
    float place_[8] = {};
    float normal_[3][8] = {};
};

class BrickHermiteTracer {
    static constexpr std::uint64_t kLastColumn = NodeBits::kFirstColumn << (kBrickSide - 1);
    static constexpr std::uint64_t kLastRow = NodeBits::kFirstRow << kBrickSide * (kBrickSide - 1);

public:
    BrickHermiteTracer(BrickMap& bricks, const BrickKey& key, const Lattice& lattice,
                       const std::vector<SweepStep>& steps, std::uint64_t carve)
        : changed_{key}, brick_(*bricks.find(key)), lattice_(lattice), steps_(steps), carve_(carve) {
        next_ = {bricks.find(key.moved(1, 0, 0)), bricks.find(key.moved(0, 1, 0)), bricks.find(key.moved(0, 0, 1))};
    }

    ChangedBrick run() {
        findCrossed();
        if (!hasCrossed()) return changed_;
        BrickSweep sweep(changed_.key, lattice_, steps_, lattice_.spacing());
        for (int block = 0; block < kBlocks; ++block) {
            listCrossed(block);
            trace(block, sweep);
        }
        return changed_;
    }

private:
    struct End {
        const Brick* brick;
        int node;
        [[nodiscard]] bool isRemoved() const { return brick->removed[node]; }
        [[nodiscard]] bool wasOpened(std::uint64_t carve) const {
            return brick->lastCarve == carve && brick->opened[node];
        }
    };
    /// A lattice edge that crosses the boundary and has an end that the carve has lowered.
    struct Crossed {
        std::array<int, 3> low;  ///< its lower end in the brick
        int axis;
    };

    [[nodiscard]] End lowEnd(const Crossed& edge) const {
        return {&brick_, nodeIndex(edge.low[0], edge.low[1], edge.low[2])};
    }
    [[nodiscard]] End highEnd(const Crossed& edge) const {
        std::array<int, 3> place = edge.low;
        const bool isBeyond = ++place[edge.axis] == kBrickSide;
        place[edge.axis] %= kBrickSide;
        return {isBeyond ? next_[edge.axis] : &brick_, nodeIndex(place[0], place[1], place[2])};
    }

    /// For each layer: the edges on each axis that begin there, have exactly one removed end, and one end that the
    /// carve has lowered. An edge that leaves the brick ends in the next one. Without a next brick the boundary goes no
    /// farther.
    void findCrossed() {
        const auto lowered = [&](const Brick* brick, int z) {
            return brick->lastCarve == carve_ ? brick->lowered.layer(z) : 0;
        };
        const auto beyond = [](int axis, std::uint64_t own, std::uint64_t next) {
            return axis == 0 ? (own >> 1 & ~kLastColumn) | (next << 7 & kLastColumn) : own >> 8 | next << 56;
        };
        for (int z = 0; z < kBrickSide; ++z) {
            const std::uint64_t removed = brick_.removed.layer(z);
            const std::uint64_t touched = lowered(&brick_, z);
            const auto find = [&](int axis, std::uint64_t removedBeyond, std::uint64_t touchedBeyond) {
                crossed_[axis][z] = (removed ^ removedBeyond) & (touched | touchedBeyond);
            };
            for (const int axis : {0, 1}) {
                const Brick* next = next_[axis];
                find(axis, beyond(axis, removed, next != nullptr ? next->removed.layer(z) : 0),
                     beyond(axis, touched, next != nullptr ? lowered(next, z) : 0));
                if (next == nullptr) crossed_[axis][z] &= ~(axis == 0 ? kLastColumn : kLastRow);
            }
            const bool isLast = z + 1 == kBrickSide;
            const Brick* above = isLast ? next_[2] : &brick_;
            const int layer = isLast ? 0 : z + 1;
            crossed_[2][z] = 0;
            if (above != nullptr) find(2, above->removed.layer(layer), lowered(above, layer));
        }
    }
    [[nodiscard]] bool hasCrossed() const {
        std::uint64_t any = 0;
        for (const auto& layers : crossed_) any = std::accumulate(layers.begin(), layers.end(), any, std::bit_or());
        return any != 0;
    }
    /// Lists the crossed edges that begin in a block.
    void listCrossed(int block) {
        constexpr std::uint64_t kCorner = 0x0F0F0F0F;  // the nodes of the first block in a layer
        const auto [x, y, z] = placeOf(nodeOfBlock(block, 0));
        const std::uint64_t inBlock = kCorner << nodeIndex(x, y, 0);
        count_ = 0;
        for (int layer = z; layer < z + kBlockSide; ++layer) {
            for (int axis = 0; axis < 3; ++axis) {
                for (std::uint64_t left = crossed_[axis][layer] & inBlock; left != 0; left &= left - 1) {
                    const int node = nodeIndex(0, 0, layer) + std::countr_zero(left);
                    TACTOOTH_ASSERT(count_ < static_cast<int>(edges_.size()));
                    edges_[count_++] = {placeOf(node), axis};
                    // The value is read after the sweep near the block is known, which leaves time for the memory
                    // access.
                    __builtin_prefetch(&brick_.boundary[axis][node], 1);
                }
            }
        }
    }
    /// Updates the crossings of the listed edges.
    void trace(int block, BrickSweep& sweep) {
        if (count_ == 0) return;
        const std::vector<SweepLanes>& steps = sweep.nearEdges(block);
        for (int first = 0; first < count_; first += 8) {
            Edges8 eight;
            const int end = std::min(count_, first + 8);
            for (int i = first; i < end; ++i) add(edges_[i], eight);
            eight.extend(steps, lattice_.spacing());
            const std::array<OctahedralNormal, 8> normals = eight.normals();
            for (int i = first; i < end; ++i) store(edges_[i], eight.place(i - first), normals[i - first]);
        }
    }

    /// Adds an edge with its stored crossing, or with a crossing at the end that the carve has removed.
    void add(const Crossed& edge, Edges8& eight) const {
        const End low = lowEnd(edge);
        const bool isUpward = low.isRemoved();
        const End removed = isUpward ? low : highEnd(edge);
        TACTOOTH_ASSERT(removed.isRemoved() && low.isRemoved() != highEnd(edge).isRemoved());
        std::array<int, 3> end = edge.low;
        if (!isUpward) ++end[edge.axis];
        for (int i = 0; i < 3; ++i) end[i] -= edge.low[i] / kBlockSide * kBlockSide;
        const float direction = isUpward ? 1 : -1;
        if (removed.wasOpened(carve_)) {
            eight.add(end, edge.axis, direction, 0, removed.brick->cutNormal[removed.node].unpackSingle());
        } else {
            const HermiteSample& stored = brick_.boundary[edge.axis][low.node];
            const float place = isUpward ? stored.place : 1 - stored.place;
            eight.add(end, edge.axis, direction, place, stored.normal.unpackSingle());
        }
    }

    void store(const Crossed& edge, float place, OctahedralNormal turned) {
        const End low = lowEnd(edge);
        TACTOOTH_ASSERT(!std::isnan(place));
        const float share = std::clamp(place, 0.0F, 1.0F);
        const float moved = low.isRemoved() ? share : 1 - share;
        HermiteSample& stored = brick_.boundary[edge.axis][low.node];
        if (moved == stored.place && turned == stored.normal) return;
        stored = {moved, turned};
        changed_.addEdge(low.node, edge.axis);
    }

    ChangedBrick changed_;
    Brick& brick_;
    std::array<const Brick*, 3> next_;
    const Lattice& lattice_;
    const std::vector<SweepStep>& steps_;
    const std::uint64_t carve_;
    std::array<std::array<std::uint64_t, kBrickSide>, 3> crossed_;  // one bit for each edge, by axis and layer
    std::array<Crossed, 3 * kBlockNodes> edges_;                    // of the current block
    int count_ = 0;
};

}  // namespace

ChangedBrick updateHermiteInBrick(BrickMap& bricks, const BrickKey& key, const Lattice& lattice,
                                  const std::vector<SweepStep>& steps, std::uint64_t carve) {
    TACTOOTH_ASSERT(bricks.find(key) != nullptr);
    TACTOOTH_ASSERT(!steps.empty());
    return BrickHermiteTracer(bricks, key, lattice, steps, carve).run();
}

}  // namespace tactooth
