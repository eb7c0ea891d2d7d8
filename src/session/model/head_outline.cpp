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

using Rings = std::vector<RevolutionEnvelope::ProfilePoint>;

/// The rings of a bur up to `end`, mm along its axis.
Rings upTo(double end, const Rings& profile) {
    Rings head;
    for (const auto& ring : profile) {
        if (ring.z <= end) {
            head.push_back(ring);
            continue;
        }
        if (head.empty()) break;
        const auto last = head.back();  // the head ends between the two
        const double share = (end - last.z) / (ring.z - last.z);
        head.push_back({last.radius + share * (ring.radius - last.radius), end});
        break;
    }
    return head;
}

/// Without the rings that are close to another and alike; the last ring stays, and those that are `widest`.
Rings thinned(const Rings& head, double widest) {
    constexpr double kAlike = 0.1;  // mm
    Rings rings;
    for (std::size_t i = 0; i < head.size(); ++i) {
        const bool isNew = rings.empty() || std::abs(head[i].z - rings.back().z) >= kAlike ||
                           std::abs(head[i].radius - rings.back().radius) >= kAlike;
        if (isNew || i + 1 == head.size() || head[i].radius == widest) rings.push_back(head[i]);
    }
    return rings;
}

}  // namespace

HeadOutline::HeadOutline(const RevolutionEnvelope& bur, double length) {
    const Rings head = upTo(length > 0 ? bur.bottom() + length : bur.top(), bur.profile());
    for (const auto& ring : head) radius_ = std::max(radius_, ring.radius);
    rings_ = thinned(head, radius_);
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
