// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "assessment/preparation/measured.h"
#include "session/track/session_track.h"

namespace tactooth {

/// How the hand has worked during a session. The time of a tick lasts until the next one, 0.05 s at most.
struct HandWork {
    double seconds = 0;   ///< length of the session
    double drilling = 0;  ///< s: the bur turns and touches
    double idle = 0;      ///< s: the bur turns and touches nothing
    double dead = 0;      ///< s: the bur neither turns nor touches, in pauses of more than 1 s
    double path = 0;      ///< of the bur's tip, mm
    double strokes = 0;   ///< contacts of the turning bur of more than 50 ms; gaps of less than 50 ms do not count
    double impulse = 0;   ///< force times time, N*s
    Measured strokeTime;  ///< median, s
    // Medians over the strokes of more than 0.3 s: see movement.h.
    Measured arcLength, jerk, frequency95;
    /// From the beginning of each stroke straight to its end, by the path of the tip between them: the sums over all
    /// strokes, 0..1. By length, because a touch that hardly moves has a ratio of noise, and a median counts it as a
    /// long stroke.
    Measured economy;
    // Over the time of contact.
    double forceMean = 0, forceRms = 0, forceP95 = 0, forcePeak = 0;  ///< N
    double forceOver2 = 0;                                            ///< share of the time with more than 2 N, 0..1
    Measured burTilt;      ///< angle of the shaft to the axis while the bur turns and touches, mean, degrees
    Measured forceSpread;  ///< within strokes, N: root mean square of their standard deviations, weighted by time
};

/// Collects the ticks of a session in their order.
class HandWorkMeter {
public:
    /// `axis`: of the preparation, unit, outward.
    explicit HandWorkMeter(const Vec3& axis = Vec3::UnitZ()) : axis_(axis) {}

    void add(const TrackTick& tick);
    /// What follows is another movement: another bur, for instance.
    void interrupt();
    /// No tick follows. Nothing where no tool has touched anything: a session that nobody has worked in, or one that
    /// follows a file of poses.
    [[nodiscard]] std::optional<HandWork> finish();

private:
    struct Moment {
        double time;      // s
        double duration;  // s
        Vec3 place;       // of the tip, mm
        double force;     // N
        double tilt;      // of the shaft from the axis, rad
        bool touches, turns;
    };
    struct Stroke {
        std::size_t first, last;  // of movement_, included
    };

    /// The tip of a movement without what is faster than a hand, at equal intervals.
    struct Smoothed {
        std::vector<Vec3> places;   // mm
        std::vector<double> speed;  // mm/s: from each place to the next
    };

    void endMovement();
    [[nodiscard]] std::vector<Stroke> strokes() const;
    void addStroke(const Stroke& stroke, const Smoothed& smoothed);
    [[nodiscard]] Measured economy() const;
    void addForces(HandWork& work);

    Vec3 axis_;
    HandWork work_;
    double tilt_ = 0;               // rad*s
    std::vector<Moment> movement_;  // without an interruption
    double firstTime_ = -1, lastTime_ = 0, pause_ = 0;
    struct Held {
        double force, duration;
    };
    std::vector<Held> held_;  // of all contacts
    std::vector<double> strokeTimes_, arcLengths_, jerks_, frequencies_;
    double strokeTime_ = 0, strokeVariance_ = 0;  // s; N^2*s
    double strokePath_ = 0, strokeSpan_ = 0;      // mm
};

/// The same of a whole session.
[[nodiscard]] std::optional<HandWork> handWork(const SessionTrack& track, const Vec3& axis);

}  // namespace tactooth
