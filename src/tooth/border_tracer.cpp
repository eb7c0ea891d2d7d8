// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/border_tracer.h"

#include <bit>
#include <limits>

namespace tactooth {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();
constexpr double kOnBorder = 1e-5;  ///< mm; as exact as an envelope's distance to a sweep
/// Share of a lattice edge; how far outside the border its normal is taken. On the line that a sharp rim has swept the
/// direction of the nearest point is only rounding; a little outside it is the normal of that line's surface.
constexpr double kNormalOffset = 0.04;
/// mm; nearer than this one more step of Newton lands on the border: to 2e-6 even on a rim rounded to 0.05 mm, and to a
/// tenth of a micrometre where it is sharp.
constexpr double kLastStep = 2e-4;
constexpr int kNewtonRounds = 20;  ///< halves the rest of the edge where Newton leaves it: 50 um / 2^20 at worst
constexpr int kExtensions = 4;     ///< steps of one move that each carry the border farther along the same edge

/// A lattice edge from its removed end (place 0) to its solid one (place `length`, mm).
struct DirectedEdge {
    Vec3 removedEnd;
    Vec3 direction;
    double length;
    [[nodiscard]] Vec3 at(double place) const { return removedEnd + place * direction; }
};

struct Border {
    double place;
    Vec3 normal;
};

/// Where the edge leaves the region that `step` sweeps, going out from `from`, where its distance is `sample`.
Border exitOf(const SweepStep& step, const DirectedEdge& edge, double from, FieldSample sample) {
    double inside = from;
    double outside = edge.length;
    double place = from;
    for (int round = 0; round < kNewtonRounds && std::abs(sample.distance) > kOnBorder; ++round) {
        const double slope = sample.gradient.dot(edge.direction);
        const bool isLast = std::abs(sample.distance) < kLastStep;
        place -= sample.distance / slope;
        if (!(place > inside && place < outside)) {
            place = 0.5 * (inside + outside);
        } else if (isLast) {
            break;
        }
        sample = step.sample(edge.at(place), kNoBound);
        (sample.distance < 0 ? inside : outside) = place;
    }
    return {place, step.sample(edge.at(place + kNormalOffset * edge.length), kNoBound).gradient};
}

/// Carries the border outward as long as one of the steps holds it. The last step reaches farthest as a rule.
void extend(Border& border, const DirectedEdge& edge, const std::vector<const SweepStep*>& steps) {
    const SweepStep* carried = nullptr;  // the step that the border was carried out of last: it does not hold it
    for (int round = 0; round < kExtensions; ++round) {
        bool moved = false;
        for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
            if (*step == carried) continue;
            const FieldSample here = (*step)->sample(edge.at(border.place), -kOnBorder);
            if (here.distance >= -kOnBorder) continue;
            const Border exit = exitOf(**step, edge, border.place, here);
            if (exit.place > border.place) border = exit, carried = *step, moved = true;
        }
        if (!moved) return;
    }
}

class BrickTracer {
public:
    BrickTracer(BrickMap& bricks, const BrickKey& key, const Lattice& lattice, const std::vector<SweepStep>& steps,
                std::uint64_t carve)
        : changed_{key},
          brick_(*bricks.find(key)),
          corner_(lattice.corner(key)),
          spacing_(lattice.spacing()),
          carve_(carve) {
        next_ = {bricks.find(key.moved(1, 0, 0)), bricks.find(key.moved(0, 1, 0)), bricks.find(key.moved(0, 0, 1))};
        for (const SweepStep& step : steps) {
            if (step.lowerBound(lattice.centre(key)) < lattice.halfDiagonal() + spacing_) steps_.push_back(&step);
        }
    }

    ChangedBrick run() {
        for (int z = 0; z < kBrickSide; ++z) {
            for (int y = 0; y < kBrickSide; ++y) {
                const unsigned row = removedRow(&brick_, y, z);
                traceCrossed((row ^ (row >> 1 | removedAt(next_[0], 0, y, z) << (kBrickSide - 1))), y, z, 0);
                const bool lastY = y + 1 == kBrickSide;
                traceCrossed(row ^ removedRow(lastY ? next_[1] : &brick_, lastY ? 0 : y + 1, z), y, z, 1);
                const bool lastZ = z + 1 == kBrickSide;
                traceCrossed(row ^ removedRow(lastZ ? next_[2] : &brick_, y, lastZ ? 0 : z + 1), y, z, 2);
            }
        }
        return changed_;
    }

private:
    struct End {
        const Brick* brick;
        int node;
        [[nodiscard]] bool isRemoved() const { return brick->cut[node] < 0; }
        [[nodiscard]] bool wasLowered(std::uint64_t carve) const {
            return brick->lastCarve == carve && brick->lowered[node];
        }
        [[nodiscard]] bool wasOpened(std::uint64_t carve) const {
            return brick->lastCarve == carve && brick->opened[node];
        }
    };

    /// Which nodes of a row along x are removed, one bit each.
    static unsigned removedRow(const Brick* brick, int y, int z) {
        unsigned bits = 0;
        for (int x = 0; brick != nullptr && x < kBrickSide; ++x) bits |= removedAt(brick, x, y, z) << x;
        return bits;
    }
    static unsigned removedAt(const Brick* brick, int x, int y, int z) {
        return brick != nullptr && brick->cut[nodeIndex(x, y, z)] < 0 ? 1U : 0U;
    }

    /// The edges of a row on one axis whose two ends are on different sides, one bit each.
    void traceCrossed(unsigned crossed, int y, int z, int axis) {
        for (; crossed != 0; crossed &= crossed - 1) trace({std::countr_zero(crossed), y, z}, axis);
    }

    void trace(std::array<int, 3> place, int axis) {
        const End low{&brick_, nodeIndex(place[0], place[1], place[2])};
        const Vec3 lowPoint = corner_ + spacing_ * Vec3(place[0], place[1], place[2]);
        const bool isBeyond = ++place[axis] == kBrickSide;
        place[axis] %= kBrickSide;
        const End high{isBeyond ? next_[axis] : &brick_, nodeIndex(place[0], place[1], place[2])};
        if (high.brick == nullptr) return;
        if (!low.wasLowered(carve_) && !high.wasLowered(carve_)) return;

        const double sign = low.isRemoved() ? 1 : -1;
        const End& removed = low.isRemoved() ? low : high;
        const Vec3 step = sign * Vec3::Unit(axis);
        const DirectedEdge edge{low.isRemoved() ? lowPoint : Vec3(lowPoint - spacing_ * step), step, spacing_};
        float& stored = brick_.borderPlace[axis][low.node];
        PackedDirection& normal = brick_.borderNormal[axis][low.node];
        Border border{0, Vec3::Zero()};
        if (removed.wasOpened(carve_)) {
            border.normal = removed.brick->cutNormal[removed.node].unpack();
        } else {
            border = {(sign > 0 ? stored : 1 - stored) * spacing_, normal.unpack()};
        }
        extend(border, edge, steps_);
        const double share = std::clamp(border.place / spacing_, 0.0, 1.0);
        const auto moved = static_cast<float>(sign > 0 ? share : 1 - share);
        const PackedDirection turned(border.normal);
        if (moved == stored && turned == normal) return;
        stored = moved;
        normal = turned;
        changed_.add(low.node);
    }

    ChangedBrick changed_;
    Brick& brick_;
    std::array<const Brick*, 3> next_;
    const Vec3 corner_;
    const double spacing_;
    const std::uint64_t carve_;
    std::vector<const SweepStep*> steps_;
};

}  // namespace

ChangedBrick traceBorderInBrick(BrickMap& bricks, const BrickKey& key, const Lattice& lattice,
                                const std::vector<SweepStep>& steps, std::uint64_t carve) {
    return BrickTracer(bricks, key, lattice, steps, carve).run();
}

}  // namespace tactooth
