// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "assessment/exercise.h"

namespace tactooth {

/// The finish line of a crown preparation on the surface of an uncut tooth, once around the axis.
class FinishLine {
public:
    /// Fails with one sentence where the tooth has no cervical line, or is too narrow.
    [[nodiscard]] static Expected<FinishLine> on(const PreparationPlan& plan, const LayeredTooth& tooth,
                                                 const std::shared_ptr<const SurfacePart>& outer);

    /// A place as seen along the axis.
    struct Place {
        double inside;  ///< distance inwards from the line, mm; negative outside
        double above;   ///< height above the line near by, mm
        Vec3 inward;    ///< gradient of `inside`
        Vec3 upward;    ///< gradient of `above`
    };
    [[nodiscard]] Place placeOf(const Vec3& point) const;

    [[nodiscard]] const Vec3& axis() const { return axis_; }
    /// The mesiodistal direction square to the axis; its sign is that of x.
    [[nodiscard]] const Vec3& across() const { return u_; }
    /// The same of the buccolingual direction.
    [[nodiscard]] const Vec3& aside() const { return v_; }
    /// Points in order, counterclockwise around the axis, mm.
    [[nodiscard]] const std::vector<Vec3>& points() const { return points_; }
    /// A point of the axis of the tooth, mm.
    [[nodiscard]] Vec3 middle() const { return middle_.x() * u_ + middle_.y() * v_; }
    [[nodiscard]] double lowest() const;  ///< height along the axis, mm

private:
    explicit FinishLine(const Vec3& axis);
    struct Height {
        double value;  // along the axis, mm
        Vec2 gradient;
    };
    [[nodiscard]] Height heightBy(const Vec2& flat, double inside, const Vec2& inward) const;

    Vec3 axis_, u_, v_;
    std::vector<Vec3> points_;
    std::vector<Vec2> flat_;       // of the points, along u_ and v_
    std::vector<double> heights_;  // of the points
    std::vector<double> lengths_;  // of the line around each of the points, mm
    Vec2 middle_ = Vec2::Zero();
};

}  // namespace tactooth
