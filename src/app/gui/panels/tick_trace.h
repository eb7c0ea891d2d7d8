// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <memory>
#include <span>

#include "collision/bvh/surface.h"
#include "haptics/haptic_simulation.h"

namespace tactooth {

/// The last seconds of a simulation, decimated for a plot: one point for each interval, with the largest values in it,
/// so that no peak is lost.
class TickTrace {
public:
    static constexpr double kInterval = 0.05;  // s: 20 points a second are finer than the plot's pixels
    static constexpr double kShown = 10;       // s

    struct Point {
        double time;         ///< end of the interval, s
        double depth;        ///< penetration depth, mm
        double speed;        ///< mm/s
        double force;        ///< N
        double cavityDepth;  ///< of the tip below the uncut surface, along the shaft, at the end of the interval, mm
    };

    /// The surface before all cuts, for the cavity depth of the ticks to come; null: it is 0.
    void setUncut(std::shared_ptr<const SurfacePart> uncut) { uncut_ = std::move(uncut); }
    /// `ticks` in the order of their time.
    void add(std::span<const Tick> ticks);
    /// Forgets all ticks.
    void clear();

    /// Complete intervals, oldest first; none older than kShown before the newest.
    [[nodiscard]] const std::deque<Point>& points() const { return points_; }

    /// Whether all points show rest.
    [[nodiscard]] bool isFlat() const;

private:
    void endInterval(double next);

    std::shared_ptr<const SurfacePart> uncut_;
    std::deque<Point> points_;
    Point current_{kInterval, 0, 0, 0, 0};
    Pose tool_;  // of the last tick
};

}  // namespace tactooth
