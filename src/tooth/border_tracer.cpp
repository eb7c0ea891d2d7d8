// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/border_tracer.h"

#include <bit>
#include <limits>

#include "collision/lane_flags.h"
#include "tooth/brick_sweep.h"

namespace tactooth {
namespace {

constexpr float kNoBound = std::numeric_limits<float>::infinity();
constexpr float kOnBorder = 1e-5F;  ///< mm; as exact as an envelope's distance to a sweep
/// Share of a lattice edge; how far outside the border its normal is taken. On the line that a sharp rim has swept the
/// direction of the nearest point is only rounding; a little outside it is the normal of that line's surface.
constexpr float kNormalOffset = 0.04F;
/// mm; nearer than this one more step of Newton lands on the border: to 2e-6 even on a rim rounded to 0.05 mm, and to a
/// tenth of a micrometre where it is sharp.
constexpr float kLastStep = 2e-4F;
constexpr int kNewtonRounds = 20;  ///< halves the rest of the edge where Newton leaves it: 50 um / 2^20 at worst
constexpr int kExtensions = 4;     ///< steps of one move that each carry the border farther along the same edge

/// Eight lattice edges of one block, each from its removed end (place 0) to its solid one (place 1), and where the
/// border of the removed region crosses them.
class Edges8 {
public:
    /// Adds an edge whose removed end is at `end`, in steps from the block's first node; `direction` leads to the solid
    /// one. `place` and `normal`: of the border as far as it is known.
    void add(const std::array<int, 3>& end, int axis, float direction, float place, const Vec3f& normal) {
        for (int i = 0; i < 3; ++i) {
            end_[i][count_] = static_cast<float>(end[i]);
            direction_[i][count_] = i == axis ? direction : 0;
            normal_[i][count_] = normal[i];
        }
        place_[count_++] = place;
    }
    [[nodiscard]] float place(int lane) const { return place_[lane]; }
    [[nodiscard]] std::array<PackedDirection, 8> normals() const {
        return PackedDirection::pack(Vec3x8::load(normal_));
    }

    /// Carries the borders outward as long as one of the steps holds them.
    void extend(const std::vector<SweepLanes>& steps, double spacing) {
        fill();
        Float8 carried = Float8::all(-1);  // the step that a border was carried out of last: it does not hold it
        bool moved = true;
        for (int round = 0; round < kExtensions && moved; ++round) {
            moved = false;
            for (std::size_t i = 0; i < steps.size(); ++i) {
                const Float8 number = Float8::all(static_cast<float>(i));
                const Float8 isOther = isLess(carried, number) + isLess(number, carried);
                moved |= carryOut(steps[i], number, isOther, carried, static_cast<float>(spacing));
            }
        }
    }

private:
    static Float8 sizeOf(Float8 distance) { return max(distance, zero8() - distance); }

    /// Lanes without an edge follow the first one.
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

    /// Moves the borders that `step` holds to where their edges leave the region that it sweeps; true if one has moved.
    bool carryOut(const SweepLanes& step, Float8 number, Float8 isOther, Float8& carried, float spacing) {
        if (!isAny(isOther)) return false;
        const Float8 start = Float8::load(place_);
        const Float8 onBorder = Float8::all(-kOnBorder);
        const Samples8 here = step.sample(at(start), onBorder);
        Float8 holds = isOther * isLess(here.distance, onBorder);
        if (!isAny(holds)) return false;
        const Float8 exit = exitOf(step, start, here, holds, spacing);
        holds = holds * isLess(start, exit);
        if (!isAny(holds)) return false;
        const Vec3x8 normal = step.sample(at(exit + Float8::all(kNormalOffset)), Float8::all(kNoBound)).gradient;
        choose(holds, exit, start).store(place_);
        choose(holds, normal, Vec3x8::load(normal_)).store(normal_);
        carried = choose(holds, number, carried);
        return true;
    }

    /// Where the edges in `searching` leave the region that `step` sweeps, going out from `start`, where its distance
    /// is `sample`: Newton's steps, halving the rest of the edge where one leaves it.
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
            searching = searching * isLess(Float8::all(kOnBorder), sizeOf(sample.distance));
        }
        return place;
    }

    int count_ = 0;
    float end_[3][8] = {};
    float direction_[3][8] = {};
    float place_[8] = {};
    float normal_[3][8] = {};
};

class BrickTracer {
public:
    BrickTracer(BrickMap& bricks, const BrickKey& key, const Lattice& lattice, const std::vector<SweepStep>& steps,
                std::uint64_t carve)
        : changed_{key},
          brick_(*bricks.find(key)),
          sweep_(key, lattice, steps, lattice.spacing()),
          spacing_(lattice.spacing()),
          carve_(carve) {
        next_ = {bricks.find(key.moved(1, 0, 0)), bricks.find(key.moved(0, 1, 0)), bricks.find(key.moved(0, 0, 1))};
    }

    ChangedBrick run() {
        for (int z = 0; z < kBrickSide; ++z) {
            for (int y = 0; y < kBrickSide; ++y) {
                const unsigned row = removedRow(&brick_, y, z);
                findCrossed((row ^ (row >> 1 | removedAt(next_[0], 0, y, z) << (kBrickSide - 1))), y, z, 0);
                const bool lastY = y + 1 == kBrickSide;
                findCrossed(row ^ removedRow(lastY ? next_[1] : &brick_, lastY ? 0 : y + 1, z), y, z, 1);
                const bool lastZ = z + 1 == kBrickSide;
                findCrossed(row ^ removedRow(lastZ ? next_[2] : &brick_, y, lastZ ? 0 : z + 1), y, z, 2);
            }
        }
        for (int block = 0; block < kBlocks; ++block) trace(block);
        return changed_;
    }

private:
    struct End {
        const Brick* brick;
        int node;
        [[nodiscard]] bool isRemoved() const {
            return (brick->removed[node / kBrickSide] >> node % kBrickSide & 1) != 0;
        }
        [[nodiscard]] bool wasLowered(std::uint64_t carve) const {
            return brick->lastCarve == carve && brick->lowered[node];
        }
        [[nodiscard]] bool wasOpened(std::uint64_t carve) const {
            return brick->lastCarve == carve && brick->opened[node];
        }
    };
    /// A lattice edge that the border crosses and an end of which the carve has lowered.
    struct Crossed {
        std::array<int, 3> low;  ///< its lower end in the brick
        int axis;
    };

    /// Which nodes of a row along x are removed, one bit each.
    static unsigned removedRow(const Brick* brick, int y, int z) {
        return brick != nullptr ? brick->removedRow(y, z) : 0;
    }
    static unsigned removedAt(const Brick* brick, int x, int y, int z) {
        return brick != nullptr ? brick->removedRow(y, z) >> x & 1U : 0U;
    }

    [[nodiscard]] End lowEnd(const Crossed& edge) const {
        return {&brick_, nodeIndex(edge.low[0], edge.low[1], edge.low[2])};
    }
    [[nodiscard]] End highEnd(const Crossed& edge) const {
        std::array<int, 3> place = edge.low;
        const bool isBeyond = ++place[edge.axis] == kBrickSide;
        place[edge.axis] %= kBrickSide;
        return {isBeyond ? next_[edge.axis] : &brick_, nodeIndex(place[0], place[1], place[2])};
    }

    /// The edges of a row on one axis whose two ends are on different sides, one bit each.
    void findCrossed(unsigned crossed, int y, int z, int axis) {
        for (; crossed != 0; crossed &= crossed - 1) {
            const Crossed edge{{std::countr_zero(crossed), y, z}, axis};
            const End high = highEnd(edge);
            if (high.brick == nullptr || (!lowEnd(edge).wasLowered(carve_) && !high.wasLowered(carve_))) continue;
            edges_[blockOf(lowEnd(edge).node)].push_back(edge);
        }
    }

    void trace(int block) {
        const std::vector<Crossed>& edges = edges_[block];
        if (edges.empty()) return;
        const std::vector<SweepLanes>& steps = sweep_.nearEdges(block);
        for (std::size_t first = 0; first < edges.size(); first += 8) {
            Edges8 eight;
            const std::size_t end = std::min(edges.size(), first + 8);
            for (std::size_t i = first; i < end; ++i) add(edges[i], eight);
            eight.extend(steps, spacing_);
            const std::array<PackedDirection, 8> normals = eight.normals();
            for (std::size_t i = first; i < end; ++i)
                store(edges[i], eight.place(static_cast<int>(i - first)), normals[i - first]);
        }
    }

    /// With the border that is stored, or at the very end that the carve has removed.
    void add(const Crossed& edge, Edges8& eight) const {
        const End low = lowEnd(edge);
        const bool isUpward = low.isRemoved();
        const End removed = isUpward ? low : highEnd(edge);
        std::array<int, 3> end = edge.low;
        if (!isUpward) ++end[edge.axis];
        for (int i = 0; i < 3; ++i) end[i] -= edge.low[i] / kBlockSide * kBlockSide;
        const float direction = isUpward ? 1 : -1;
        if (removed.wasOpened(carve_)) {
            eight.add(end, edge.axis, direction, 0, removed.brick->cutNormal[removed.node].unpackSingle());
        } else {
            const BorderCrossing& stored = brick_.border[edge.axis][low.node];
            const float place = isUpward ? stored.place : 1 - stored.place;
            eight.add(end, edge.axis, direction, place, stored.normal.unpackSingle());
        }
    }

    void store(const Crossed& edge, float place, PackedDirection turned) {
        const End low = lowEnd(edge);
        const float share = std::clamp(place, 0.0F, 1.0F);
        const float moved = low.isRemoved() ? share : 1 - share;
        BorderCrossing& stored = brick_.border[edge.axis][low.node];
        if (moved == stored.place && turned == stored.normal) return;
        stored = {moved, turned};
        changed_.add(low.node);
    }

    ChangedBrick changed_;
    Brick& brick_;
    std::array<const Brick*, 3> next_;
    BrickSweep sweep_;
    const double spacing_;
    const std::uint64_t carve_;
    std::array<std::vector<Crossed>, kBlocks> edges_;
};

}  // namespace

ChangedBrick traceBorderInBrick(BrickMap& bricks, const BrickKey& key, const Lattice& lattice,
                                const std::vector<SweepStep>& steps, std::uint64_t carve) {
    return BrickTracer(bricks, key, lattice, steps, carve).run();
}

}  // namespace tactooth
