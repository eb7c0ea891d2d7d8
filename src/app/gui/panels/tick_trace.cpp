// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/tick_trace.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "session/control/surface_ray.h"

namespace tactooth {

namespace {

constexpr double kRounding = 1e-6;  // of an interval: a tick on the boundary begins the next interval

}  // namespace

/// A cavity grows by less than the plot shows within an interval: its depth is computed once for each.
void TickTrace::endInterval(double next) {
    if (uncut_ != nullptr) {
        current_.cavityDepth = depthInside(*uncut_, tool_.position, tool_.rotation * Vec3::UnitZ());
    }
    points_.push_back(current_);
    current_ = {kInterval * (std::floor(next / kInterval + kRounding) + 1), 0, 0, 0, 0};
}

void TickTrace::add(std::span<const Tick> ticks) {
    for (const Tick& tick : ticks) {
        if (tick.time >= current_.time) endInterval(tick.time);
        tool_ = tick.contact.proxy;
        current_.depth = std::max(current_.depth, tick.contact.depth);
        current_.speed = std::max(current_.speed, tick.input.speed);
        current_.force = std::max(current_.force, tick.force.wrench.force.norm());
    }
    while (!points_.empty() && points_.front().time < points_.back().time - kShown - kRounding) points_.pop_front();
}

bool TickTrace::isFlat() const {
    constexpr double kSpeed = 0.1, kElse = 0.001;  // mm/s; mm and N: less than a plot can show
    return std::none_of(points_.begin(), points_.end(), [](const Point& point) {
        return point.speed > kSpeed || point.depth > kElse || point.force > kElse;
    });
}

void TickTrace::clear() {
    TickTrace empty;
    empty.setUncut(std::move(uncut_));
    *this = std::move(empty);
}

}  // namespace tactooth
