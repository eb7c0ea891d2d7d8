// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/anatomy/variation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "instruments/anatomy/deviation.h"
#include "instruments/modelling/blend.h"

namespace tactooth {
namespace {

/// Maps a point of the varied tooth to that of the average tooth. It changes lengths by less than a fifth, so that
/// nested layers stay nested and values stay close to distances.
class ShapeWarp {
public:
    ShapeWarp(std::uint32_t seed, int fdi) {
        std::mt19937 mouth(seed), tooth(seed * 100 + placeOfTooth(fdi));
        const double size = 1 + deviation(mouth, 0.045), slender = deviation(mouth, 0.025);
        crown_ = size + slender + deviation(tooth, 0.03);
        root_ = size + slender + deviation(tooth, 0.09);
        wide_ = Vec3(size - slender + deviation(tooth, 0.03), size - slender + deviation(tooth, 0.03), 1);
        bendX_ = deviation(tooth, 0.006);
        bendY_ = deviation(tooth, 0.004);
        twist_ = deviation(tooth, 0.012);
        for (Vec3& wave : waves_) wave = Vec3(deviation(tooth, 0.75), deviation(tooth, 0.75), deviation(tooth, 0.55));
        for (double& phase : phases_) phase = deviation(tooth, std::numbers::pi);
    }

    [[nodiscard]] Vec3 operator()(const Vec3& p) const {
        const double below = std::max(0.0, -p.z());
        const double angle = twist_ * p.z();
        const double c = std::cos(angle), s = std::sin(angle);
        const double x = p.x() - bendX_ * below * below, y = p.y() - bendY_ * below * below;
        Vec3 q(c * x - s * y, s * x + c * y, p.z());
        constexpr double kHeight = 0.06;  // mm: amplitude of each wave
        for (int axis = 0; axis < 3; ++axis) {
            q[axis] += kHeight * std::sin(waves_[axis].dot(p) + phases_[axis]);
        }
        return {q.x() / wide_.x(), q.y() / wide_.y(), q.z() / (q.z() > 0 ? crown_ : root_)};
    }

    [[nodiscard]] Box3 around(const Box3& average) const {
        constexpr double kMargin = 1.6;  // mm: bends and waves
        const Vec3 low(wide_.x() * average.min().x(), wide_.y() * average.min().y(), root_ * average.min().z());
        const Vec3 high(wide_.x() * average.max().x(), wide_.y() * average.max().y(), crown_ * average.max().z());
        return {low.array() - kMargin, high.array() + kMargin};
    }

private:
    double crown_, root_;  ///< stretch of the heights above and below the neck
    Vec3 wide_;            ///< stretch of the widths
    double bendX_, bendY_, twist_;
    std::array<Vec3, 3> waves_;
    std::array<double, 3> phases_;
};

/// The point of the varied tooth that the warp maps to `average`.
Vec3 unwarped(const ShapeWarp& warp, const Vec3& average) {
    constexpr int kRounds = 30;  // the warp is close to the identity: each round leaves a fifth of the error
    Vec3 point = average;
    for (int i = 0; i < kRounds; ++i) point += average - warp(point);
    return point;
}

}  // namespace

ToothShape varied(const ToothShape& planned, std::uint32_t seed) {
    if (seed == 0) return planned;
    const ShapeWarp warp(seed, planned.fdi);
    const auto through = [&](const ScalarField& field) {
        return [field, warp](const Vec3& p) { return field(warp(p)); };
    };
    ToothShape shape = planned;
    shape.bounds = warp.around(planned.bounds);
    shape.outer = through(planned.outer);
    shape.core = through(planned.core);
    shape.cervical = through(planned.cervical);
    shape.pulp = through(planned.pulp);
    shape.lesionSite = unwarped(warp, planned.lesionSite);
    return shape;
}

}  // namespace tactooth
