// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/qp6.h"

#include <algorithm>
#include <limits>

#include "geometry/util/assert.h"

// D. Goldfarb, A. Idnani, "A Numerically Stable Dual Method for Solving Strictly Convex Quadratic Programs",
// Mathematical Programming 27, 1983, section 3, for a Hessian that is the identity: the point starts at the target.
// Each step adds the most violated half-space to the active set, and drops half-spaces whose multiplier becomes zero.
// Differs from the paper: with six planes at most, the projections are computed afresh instead of being updated.

namespace tactooth {
namespace {

constexpr int kMaxSteps = 200;      // a step adds a half-space or drops one: 2-10 are usual
constexpr double kParallel = 1e-9;  // share of a normal's length that must be outside the span of the active normals

using Small = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;

class Search {
public:
    Search(std::span<const HalfSpace6> halfSpaces, const Vec6& target) : halfSpaces_(halfSpaces), point_(target) {}

    bool run(double tolerance) {
        while (steps_ < kMaxSteps) {
            const int worst = mostViolated(tolerance);
            if (worst < 0) return true;
            if (!activate(worst)) return false;
        }
        return false;
    }

    [[nodiscard]] Qp6Result answer() const {
        Qp6Result result;
        result.feasible = true;
        result.point = point_;
        result.activeCount = count_;
        result.active = active_;
        result.multiplier = multiplier_;
        return result;
    }

private:
    /// By how much the point violates half-space `i`; negative: not at all.
    [[nodiscard]] double missing(int i) const { return halfSpaces_[i].offset - halfSpaces_[i].normal.dot(point_); }

    [[nodiscard]] int mostViolated(double tolerance) const {
        int worst = -1;
        for (int i = 0; i < static_cast<int>(halfSpaces_.size()); ++i) {
            if (missing(i) <= tolerance) continue;
            const bool isActive = std::find(active_.begin(), active_.begin() + count_, i) != active_.begin() + count_;
            if (!isActive && (worst < 0 || missing(i) > missing(worst))) worst = i;
        }
        return worst;
    }

    /// A normal as a combination of the active ones, and the rest.
    struct Parts {
        Small ofActive;
        Vec6 rest;
    };
    [[nodiscard]] Parts partsOf(const Vec6& normal) const {
        if (count_ == 0) return {Small(), normal};
        Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6> normals(6, count_);
        for (int i = 0; i < count_; ++i) normals.col(i) = halfSpaces_[active_[i]].normal;
        const Small ofActive = normals.householderQr().solve(normal);
        return {ofActive, normal - normals * ofActive};
    }

    /// The active half-space whose multiplier a new one would first make zero, and the multiplier of the new one then.
    struct Block {
        int place = -1;
        double push = std::numeric_limits<double>::infinity();
    };
    [[nodiscard]] Block firstToRelease(const Small& ofActive) const {
        Block block;
        for (int i = 0; i < count_; ++i) {
            if (!(ofActive[i] > 0)) continue;
            if (const double push = multiplier_[i] / ofActive[i]; push < block.push) block = {i, push};
        }
        return block;
    }

    /// Moves the point into half-space `entering`. False if it has no common point with the active ones.
    bool activate(int entering) {
        TACTOOTH_ASSERT(entering >= 0 && entering < static_cast<int>(halfSpaces_.size()));
        const Vec6& normal = halfSpaces_[entering].normal;
        double push = 0;
        while (++steps_ <= kMaxSteps) {
            const Parts parts = partsOf(normal);
            const Block block = firstToRelease(parts.ofActive);
            const double outside = parts.rest.squaredNorm();
            const bool isNew = count_ < 6 && outside > kParallel * kParallel * normal.squaredNorm();
            const double full = isNew ? missing(entering) / outside : std::numeric_limits<double>::infinity();
            if (!isNew && block.place < 0) return false;
            const double step = std::min(full, block.push);
            if (isNew) point_ += step * parts.rest;
            for (int i = 0; i < count_; ++i) multiplier_[i] = std::max(0.0, multiplier_[i] - step * parts.ofActive[i]);
            push += step;
            if (full <= block.push) {
                TACTOOTH_ASSERT(count_ < 6);
                active_[count_] = entering;
                multiplier_[count_++] = push;
                return true;
            }
            TACTOOTH_ASSERT(block.place >= 0 && block.place < count_);
            std::copy(active_.begin() + block.place + 1, active_.begin() + count_, active_.begin() + block.place);
            std::copy(multiplier_.begin() + block.place + 1, multiplier_.begin() + count_,
                      multiplier_.begin() + block.place);
            --count_;
        }
        return false;
    }

    std::span<const HalfSpace6> halfSpaces_;
    Vec6 point_;
    int steps_ = 0;
    int count_ = 0;
    std::array<int, 6> active_{};
    std::array<double, 6> multiplier_{};
};

}  // namespace

Qp6Result solveQp6(std::span<const HalfSpace6> halfSpaces, const Vec6& target, double tolerance) {
    TACTOOTH_ASSERT(target.allFinite());
    TACTOOTH_ASSERT(tolerance >= 0);
    Search search(halfSpaces, target);
    return search.run(tolerance) ? search.answer() : Qp6Result{};
}

}  // namespace tactooth
