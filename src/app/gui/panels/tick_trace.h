// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <span>

#include "haptics/haptic_simulation.h"

namespace tactooth {

/// The last seconds of a simulation, decimated for a plot: one point for each interval, with the largest values in it,
/// so that no peak is lost.
class TickTrace {
public:
    static constexpr double kInterval = 0.05;  // s: 20 points a second are finer than the plot's pixels
    static constexpr double kShown = 10;       // s

    struct Point {
        double time;   ///< end of the interval, s
        double depth;  ///< mm
        double speed;  ///< mm/s
        double force;  ///< N
    };

    /// `ticks` in the order of their time.
    void add(std::span<const Tick> ticks);
    void clear();

    /// Complete intervals, oldest first; none older than kShown before the newest.
    [[nodiscard]] const std::deque<Point>& points() const { return points_; }

    /// Whether all points show rest.
    [[nodiscard]] bool isFlat() const;

private:
    std::deque<Point> points_;
    Point current_{kInterval, 0, 0, 0};
};

}  // namespace tactooth
