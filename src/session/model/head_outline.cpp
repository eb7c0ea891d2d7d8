// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/head_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tactooth {
namespace {

/// Counter-clockwise (Andrew's monotone chain, 1979).
std::vector<Vec2> convexHull(std::vector<Vec2> places) {
    std::ranges::sort(places,
                      [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    const auto bendsRight = [](const Vec2& a, const Vec2& b, const Vec2& c) {
        const Vec2 first = b - a, second = c - a;
        return first.x() * second.y() - first.y() * second.x() <= 0;
    };
    std::vector<Vec2> hull;
    for (const bool isUpper : {false, true}) {
        const std::size_t begin = hull.size();
        for (const Vec2& place : places) {
            while (hull.size() >= begin + 2 && bendsRight(hull[hull.size() - 2], hull.back(), place)) hull.pop_back();
            hull.push_back(place);
        }
        hull.pop_back();  // begins the other half
        if (!isUpper) std::ranges::reverse(places);
    }
    return hull;
}

/// `count` places along a closed line, at equal distances.
std::vector<Vec2> evenly(const std::vector<Vec2>& line, int count) {
    const auto after = [&](std::size_t i) { return line[(i + 1) % line.size()]; };
    double whole = 0;
    for (std::size_t i = 0; i < line.size(); ++i) whole += (after(i) - line[i]).norm();
    std::vector<Vec2> places;
    if (!(whole > 0)) return places;
    double passed = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec2 edge = after(i) - line[i];
        const double length = edge.norm();
        while (static_cast<int>(places.size()) < count) {
            const double along = whole * static_cast<double>(places.size()) / count - passed;
            if (along >= length) break;
            places.push_back(line[i] + along / length * edge);
        }
        passed += length;
    }
    return places;
}

}  // namespace

/// Rings that are close together and alike count as one.
HeadOutline::HeadOutline(const RevolutionEnvelope& bur, double length) {
    constexpr double kAlike = 0.1;  // mm
    const auto& profile = bur.profile();
    const double end = length > 0 ? bur.bottom() + length : bur.top();
    for (const auto& ring : profile) radius_ = ring.z <= end ? std::max(radius_, ring.radius) : radius_;
    for (std::size_t i = 0; i < profile.size() && profile[i].z <= end; ++i) {
        const auto& ring = profile[i];
        const bool isLast = i + 1 == profile.size() || profile[i + 1].z > end;
        const bool isNew = rings_.empty() || std::abs(ring.z - rings_.back().z) >= kAlike ||
                           std::abs(ring.radius - rings_.back().radius) >= kAlike;
        if (isNew || isLast || ring.radius == radius_) rings_.push_back(ring);
        if (!isLast || i + 1 == profile.size()) continue;
        const auto& next = profile[i + 1];  // the head ends between the two
        rings_.push_back({ring.radius + (end - ring.z) / (next.z - ring.z) * (next.radius - ring.radius), end});
    }
    for (const auto& ring : rings_) radius_ = std::max(radius_, ring.radius);
}

/// The envelope of an instrument that does not turn is not its shape.
HeadOutline::HeadOutline(const SessionBur& bur) : HeadOutline(bur.instrument.cutting.envelope, bur.head.length) {
    if (!bur.isHandInstrument()) return;
    radius_ = bur.head.radius;
    rings_ = {{bur.head.radius, 0}, {bur.head.radius, bur.head.length}};
}

std::vector<Vec3> HeadOutline::seenAlong(const Vec3& inward, const Quat& tool) const {
    const Vec3 u = inward.unitOrthogonal();
    const Vec3 v = inward.cross(u);
    const auto onCircle = [](double radius, int i) {
        const double angle = 2 * std::numbers::pi * i / kPlaces;
        return Vec2(radius * std::cos(angle), radius * std::sin(angle));
    };
    constexpr double kParallel = 1e-9;  // 1 minus the cosine
    std::vector<Vec3> outline;
    if (std::abs((tool * Vec3::UnitZ()).dot(inward)) > 1 - kParallel) {  // along its shaft a bur is a disc
        for (int i = 0; i < kPlaces; ++i) {
            const Vec2 place = onCircle(radius_, i);
            outline.push_back(place.x() * u + place.y() * v);
        }
        return outline;
    }
    std::vector<Vec2> seen;
    for (const RevolutionEnvelope::ProfilePoint& ring : rings_) {
        for (int i = 0; i < kPlaces; ++i) {
            const Vec2 round = onCircle(ring.radius, i);
            const Vec3 place = tool * Vec3(round.x(), round.y(), ring.z);
            seen.emplace_back(place.dot(u), place.dot(v));
        }
    }
    for (const Vec2& place : evenly(convexHull(std::move(seen)), kPlaces)) {
        outline.push_back(place.x() * u + place.y() * v);
    }
    return outline;
}

}  // namespace tactooth
