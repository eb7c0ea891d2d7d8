// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/crown/finish_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "assessment/messages.h"
#include "collision/bvh/closest_point.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr int kPoints = 240;           // of the line
constexpr double kSmoothing = 5;       // points: standard deviation of the smoothing of heights
constexpr double kNoEnamel = 0.04;     // mm of enamel: thinner is none
constexpr double kDown = 0.1;          // mm between two heights of the search
constexpr double kFarAside = 60;       // mm
constexpr double kSlimmestNeck = 1.0;  // mm from the axis
constexpr double kBlend = 0.1;  // mm of the line, over which its height counts for a place on it: standard deviation
constexpr double kBlendInside = 0.4;  // further mm for each mm inside

/// The body of one tissue of the tooth itself.
std::shared_ptr<const SurfacePart> tissueOf(const LayeredTooth& tooth, MaterialRole role) {
    const Box3 own = tooth.ownBox();
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        if (own.contains(layer.part->tree().box().center()) && tooth.materials().hasRole(layer.material, role))
            return layer.part;
    }
    return nullptr;
}

/// Mean of the neighbours round a closed line, by a Gaussian curve.
std::vector<double> smoothedRound(const std::vector<double>& values) {
    const auto count = static_cast<int>(values.size());
    const int reach = static_cast<int>(std::ceil(3 * kSmoothing));
    std::vector<double> result(values.size());
    for (int i = 0; i < count; ++i) {
        double sum = 0, weights = 0;
        for (int k = -reach; k <= reach; ++k) {
            const double weight = std::exp(-k * k / (2 * kSmoothing * kSmoothing));
            sum += weight * values[static_cast<std::size_t>((i + k + count) % count)];
            weights += weight;
        }
        result[static_cast<std::size_t>(i)] = sum / weights;
    }
    return result;
}

/// Looks at a tooth from the side, once round its axis.
class RoundTooth {
public:
    RoundTooth(std::shared_ptr<const SurfacePart> outer, const Vec3& axis, const Vec3& u, const Vec3& v)
        : surface_{.base = std::move(outer)}, axis_(axis), u_(u), v_(v) {}

    /// The axis goes through the middle of these vertices.
    void centreOn(const std::vector<Vec3f>& vertices, double above) {
        Eigen::AlignedBox2d box;
        for (const Vec3f& vertex : vertices) {
            const Vec3 place = vertex.cast<double>();
            if (axis_.dot(place) > above) box.extend(Vec2(u_.dot(place), v_.dot(place)));
        }
        if (!box.isEmpty()) middle_ = box.center();
    }
    [[nodiscard]] const Vec2& middle() const { return middle_; }

    [[nodiscard]] static double angleOf(int i) { return 2 * std::numbers::pi * i / kPoints; }

    /// The outside of the tooth at a height.
    [[nodiscard]] std::optional<Vec3> outside(int i, double height) const {
        const Vec3 outward = std::cos(angleOf(i)) * u_ + std::sin(angleOf(i)) * v_;
        const Vec3 from = middle_.x() * u_ + middle_.y() * v_ + height * axis_ + kFarAside * outward;
        const auto hit = firstHit(surface_, {from, -outward});
        if (!hit || kFarAside - *hit < kSlimmestNeck) return std::nullopt;
        return from - *hit * outward;
    }

    /// Where the enamel ends, going down from `start`; nothing if it does not end above `end`.
    [[nodiscard]] std::optional<double> enamelEnd(int i, const SurfacePart& dentin, double start, double end) const {
        double before = kNoEnamel;
        for (double height = start; height > end; height -= kDown) {
            const auto place = outside(i, height);
            if (!place) return std::nullopt;
            const double enamel = closestPoint(dentin, *place)->distance;
            if (enamel < kNoEnamel) {
                const double over = before > enamel ? (kNoEnamel - enamel) / (before - enamel) : 0;
                return height + kDown * std::clamp(over, 0.0, 1.0);
            }
            before = enamel;
        }
        return std::nullopt;
    }

private:
    Surface surface_;
    Vec3 axis_, u_, v_;
    Vec2 middle_ = Vec2::Zero();
};

}  // namespace

FinishLine::FinishLine(const Vec3& axis) : axis_(axis) {
    const Vec3 level = Vec3::UnitX() - axis.x() * axis;
    u_ = level.norm() > 0.1 ? level.normalized() : axis.unitOrthogonal();
    v_ = axis.cross(u_);
}

Expected<FinishLine> FinishLine::on(const PreparationPlan& plan, const LayeredTooth& tooth,
                                    const std::shared_ptr<const SurfacePart>& outer) {
    const CrownOutline& crown = *plan.crown;
    FinishLine line(plan.outward);
    RoundTooth round(outer, line.axis_, line.u_, line.v_);
    std::vector<double> cervical(kPoints, crown.cervical.value_or(0));
    if (crown.cervical) {
        round.centreOn(outer->mesh().vertices, *crown.cervical);
    } else {
        const auto enamel = tissueOf(tooth, MaterialRole::Enamel), dentin = tissueOf(tooth, MaterialRole::Dentin);
        if (enamel == nullptr || dentin == nullptr) return unexpected(msg::kNoCervicalLine);
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Vec3f& vertex : enamel->mesh().vertices) {
            low = std::min(low, line.axis_.dot(vertex.cast<double>()));
            high = std::max(high, line.axis_.dot(vertex.cast<double>()));
        }
        round.centreOn(enamel->mesh().vertices, low);
        for (int i = 0; i < kPoints; ++i) {
            const auto end = round.enamelEnd(i, *dentin, (low + high) / 2, low - 1);
            if (!end) return unexpected(msg::kNoCervicalLine);
            cervical[static_cast<std::size_t>(i)] = *end;
        }
        cervical = smoothedRound(cervical);
    }
    line.middle_ = round.middle();
    for (int i = 0; i < kPoints; ++i) {
        const double towardX = std::cos(RoundTooth::angleOf(i));
        const double proximal = towardX > 0 ? crown.plusXHeight : crown.minusXHeight;
        const double height =
            cervical[static_cast<std::size_t>(i)] + crown.height + towardX * towardX * (proximal - crown.height);
        const auto place = round.outside(i, height);
        if (!place) return unexpected(msg::kFinishLineOffTooth);
        line.points_.push_back(*place);
        line.flat_.emplace_back(line.u_.dot(*place), line.v_.dot(*place));
        line.heights_.push_back(height);
    }
    for (std::size_t i = 0; i < kPoints; ++i) {
        const Vec2 &before = line.flat_[(i + kPoints - 1) % kPoints], &after = line.flat_[(i + 1) % kPoints];
        line.lengths_.push_back(((line.flat_[i] - before).norm() + (after - line.flat_[i]).norm()) / 2);
    }
    return line;
}

FinishLine::Place FinishLine::placeOf(const Vec3& point) const {
    const Vec2 flat(u_.dot(point), v_.dot(point));
    double least = std::numeric_limits<double>::infinity();
    Vec2 nearest = flat, along = Vec2::UnitX();
    bool isInside = false;
    for (std::size_t i = 0; i < flat_.size(); ++i) {
        const std::size_t next = (i + 1) % flat_.size();
        const Vec2 side = flat_[next] - flat_[i], from = flat - flat_[i];
        const double share = std::clamp(from.dot(side) / side.squaredNorm(), 0.0, 1.0);
        const double squared = (from - share * side).squaredNorm();
        const bool crosses = (flat_[i].y() > flat.y()) != (flat_[next].y() > flat.y());
        if (crosses && from.x() < from.y() / side.y() * side.x()) isInside = !isInside;
        if (squared >= least) continue;
        least = squared;
        nearest = flat_[i] + share * side;
        along = side.normalized();
    }
    const double distance = std::sqrt(least);
    // On the line itself, inwards is to the left of it.
    Vec2 inward(-along.y(), along.x());
    if (distance > 1e-9) inward = (isInside ? 1 : -1) / distance * (flat - nearest);
    const double inside = isInside ? distance : -distance;
    const Height height = heightBy(flat, inside, inward);
    return {.inside = inside,
            .above = axis_.dot(point) - height.value,
            .inward = inward.x() * u_ + inward.y() * v_,
            .upward = axis_ - (height.gradient.x() * u_ + height.gradient.y() * v_)};
}

/// A mean of the heights of the points near `flat`. The height of the nearest one would jump where another becomes the
/// nearest, at the corners of the stump.
FinishLine::Height FinishLine::heightBy(const Vec2& flat, double inside, const Vec2& inward) const {
    const double depth = kBlendInside * std::max(inside, 0.0), variance = kBlend * kBlend + depth * depth;
    const Vec2 widening = 2 * kBlendInside * depth * inward;  // gradient of the variance
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& each : flat_) least = std::min(least, (flat - each).squaredNorm());
    double weights = 0, heights = 0;
    Vec2 change = Vec2::Zero(), heightChange = Vec2::Zero();  // gradients of these sums but for a common part
    for (std::size_t i = 0; i < flat_.size(); ++i) {
        const double farther = (flat - flat_[i]).squaredNorm() - least;
        constexpr double kNothing = 24;  // variances: e^-12
        if (farther > kNothing * variance) continue;
        const double weight = lengths_[i] * std::exp(-farther / (2 * variance));
        const Vec2 gradient = weight / variance * (flat_[i] - flat + farther / (2 * variance) * widening);
        weights += weight;
        heights += weight * heights_[i];
        change += gradient;
        heightChange += heights_[i] * gradient;
    }
    const double height = heights / weights;
    return {height, (heightChange - height * change) / weights};
}

double FinishLine::lowest() const { return *std::ranges::min_element(heights_); }

}  // namespace tactooth
