// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/tick_trace.h"

#include <algorithm>
#include <cmath>

namespace tactooth {

void TickTrace::add(std::span<const Tick> ticks) {
    for (const Tick& tick : ticks) {
        if (tick.time >= growing_.time) {
            points_.push_back(growing_);
            growing_ = {kStretch * (std::floor(tick.time / kStretch) + 1), 0, 0, 0};
        }
        growing_.depth = std::max(growing_.depth, tick.depth);
        growing_.speed = std::max(growing_.speed, tick.speed);
        growing_.force = std::max(growing_.force, tick.wrench.force.norm());
    }
    while (!points_.empty() && points_.front().time < points_.back().time - kShown) points_.pop_front();
}

void TickTrace::clear() { *this = TickTrace(); }

}  // namespace tactooth
