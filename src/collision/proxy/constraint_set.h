// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "collision/neighbours/separating_planes.h"
#include "collision/proxy/move_result.h"
#include "collision/proxy/qp3.h"
#include "collision/proxy/qp6.h"
#include "geometry/util/assert.h"

namespace tactooth {

/// The half-spaces, answers and solvers of a QP in 3 and in 6 unknowns.
template <int kUnknowns>
struct QpTypes;
template <>
struct QpTypes<3> {
    using Vector = Vec3;
    using Space = HalfSpace;
    using Answer = Qp3Result;
    static Answer solve(std::span<const Space> spaces, const Vector& target, double tolerance) {
        return solveQp3(spaces, target, tolerance);
    }
};
template <>
struct QpTypes<6> {
    using Vector = Vec6;
    using Space = HalfSpace6;
    using Answer = Qp6Result;
    static Answer solve(std::span<const Space> spaces, const Vector& target, double tolerance) {
        return solveQp6(spaces, target, tolerance);
    }
};

/// How exactly the constraints of an iteration are solved for, in margins.
inline constexpr double kSolveTolerance = 1e-3;

/// The constraints of one iteration: pairs of triangles, each with the half-space of steps that keeps the pair apart,
/// and those of them that are active in the last answer. `kUnknowns` is 3 or 6. Fixed memory.
template <int kUnknowns>
class ConstraintSet {
public:
    using Types = QpTypes<kUnknowns>;
    using Vector = typename Types::Vector;
    using Space = typename Types::Space;
    using Answer = typename Types::Answer;
    /// 3 to 6 constraints are usual. More means that the step is long for its surroundings.
    static constexpr int kCapacity = 32;
    static constexpr int kMaxActive = kUnknowns;

    /// Removes the constraints. The active set stays until the next answer.
    void clear() { count_ = 0; }
    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] bool isFull() const { return count_ == kCapacity; }

    /// Adds a constraint. Returns its number.
    int add(const WatchedPair& watched, const Space& space) {
        TACTOOTH_ASSERT(!isFull());
        set(count_, watched, space);
        return count_ - 1;
    }
    /// Replaces a constraint, or adds one where `number` is count().
    void set(int number, const WatchedPair& watched, const Space& space) {
        TACTOOTH_ASSERT(number >= 0 && number <= count_ && number < kCapacity);
        TACTOOTH_ASSERT(space.normal.allFinite());
        if (number == count_) ++count_;
        watched_[number] = watched;
        spaces_[number] = space;
    }
    [[nodiscard]] const WatchedPair& watched(int number) const {
        TACTOOTH_ASSERT(number >= 0 && number < kCapacity);
        return watched_[number];
    }
    [[nodiscard]] std::span<const Space> spaces() const { return {spaces_.data(), static_cast<std::size_t>(count_)}; }

    /// The point nearest to `target` that meets all constraints, to `tolerance`. Does not change the active set.
    [[nodiscard]] Answer nearest(const Vector& target, double tolerance) const {
        TACTOOTH_ASSERT(tolerance >= 0);
        return Types::solve(spaces(), target, tolerance);
    }
    /// Takes the active set of an answer of nearest().
    void setActive(const Answer& answer) {
        TACTOOTH_ASSERT(answer.feasible);
        TACTOOTH_ASSERT(answer.activeCount >= 0 && answer.activeCount <= kMaxActive);
        activeCount_ = answer.activeCount;
        std::copy_n(answer.active.begin(), activeCount_, active_.begin());
        std::copy_n(answer.multiplier.begin(), activeCount_, multiplier_.begin());
    }

    [[nodiscard]] int activeCount() const { return activeCount_; }
    /// The numbers of the active constraints.
    [[nodiscard]] std::span<const int> active() const {
        return {active_.data(), static_cast<std::size_t>(activeCount_)};
    }
    /// Multiplier of the i-th active constraint, never negative.
    [[nodiscard]] double multiplier(int i) const {
        TACTOOTH_ASSERT(i >= 0 && i < activeCount_);
        return multiplier_[i];
    }
    /// Normal of the plane of the i-th active constraint.
    [[nodiscard]] const Vec3& activeNormal(int i) const {
        TACTOOTH_ASSERT(i >= 0 && i < activeCount_);
        return watched_[active_[i]].plane.normal;
    }
    [[nodiscard]] bool isActive(int number) const { return std::ranges::find(active(), number) != active().end(); }

private:
    int count_ = 0;
    int activeCount_ = 0;
    std::array<int, kMaxActive> active_{};
    std::array<double, kMaxActive> multiplier_{};
    std::array<Space, kCapacity> spaces_;
    std::array<WatchedPair, kCapacity> watched_;
};

}  // namespace tactooth
