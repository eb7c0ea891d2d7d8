// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/tick_trace.h"

#include <algorithm>
#include <cmath>

namespace tactooth {

namespace {

constexpr double kRounding = 1e-6;  // of a stretch: a tick on the border begins the next one

}  // namespace

void TickTrace::add(std::span<const Tick> ticks) {
    for (const Tick& tick : ticks) {
        if (tick.time >= growing_.time) {
            points_.push_back(growing_);
            growing_ = {kStretch * (std::floor(tick.time / kStretch + kRounding) + 1), 0, 0, 0};
        }
        growing_.depth = std::max(growing_.depth, tick.depth);
        growing_.speed = std::max(growing_.speed, tick.speed);
        growing_.force = std::max(growing_.force, tick.wrench.force.norm());
    }
    while (!points_.empty() && points_.front().time < points_.back().time - kShown - kRounding) points_.pop_front();
}

bool TickTrace::isQuiet() const {
    constexpr double kSpeed = 0.1, kElse = 0.001;  // mm/s; mm and N: below what a plot shows
    return std::none_of(points_.begin(), points_.end(), [](const Point& point) {
        return point.speed > kSpeed || point.depth > kElse || point.force > kElse;
    });
}

void TickTrace::clear() { *this = TickTrace(); }

}  // namespace tactooth
