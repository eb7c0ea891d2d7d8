// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "collision/proxy/proxy_solver.h"
#include "instruments/tool_trajectory.h"

namespace tactooth {

inline constexpr double kSlowSpeed = 10;   ///< mm/s: the "low speed" of the published measurements, 1 cm/s
inline constexpr double kFastSpeed = 100;  ///< mm/s: the "high speed", 10 cm/s

/// The device path of the standard measurement: it comes down on the tooth, presses 0.3 mm into it, slides over cusps
/// and fissures and leaves, turning by 60 degrees/s about the tip. `speed` in mm/s; a fast path goes to and fro more
/// often.
[[nodiscard]] ToolTrajectory standardToolPath(double speed);

/// Processor time of the ticks of one path. The quantiles are over the ticks in contact.
struct ContactTiming {
    std::size_t ticks = 0;
    std::size_t inContact = 0;
    double p50 = 0;                      ///< us
    double p99 = 0;                      ///< us
    double p999 = 0;                     ///< us
    double largest = 0;                  ///< us, of all ticks, with and without contact
    double contacts = 0;                 ///< triangles that hold the tool, mean over the ticks in contact
    double iterations = 0;               ///< of the solver, mean over the ticks in contact
    double distances = 0;                ///< GJK runs, mean over the ticks in contact
    std::size_t iterationLimitHits = 0;  ///< ticks that ran out of their work budget
    std::size_t overlapping = 0;         ///< ticks whose start was not free
};

/// Moves `tool` along `devicePath` (the first pose free, one pose a millisecond) `repeat` times and takes the least
/// time of each tick, so that interruptions do not count.
[[nodiscard]] ContactTiming timeContact(const std::shared_ptr<const Surface>& surface,
                                        const std::shared_ptr<const ToolShape>& tool, std::span<const Pose> devicePath,
                                        int repeat, Freedom freedom = Freedom::Translation);

/// A surface of one part, without tags.
[[nodiscard]] std::shared_ptr<const Surface> plainSurface(TriangleMesh mesh);

}  // namespace tactooth
