// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "collision/bvh/surface.h"
#include "session/simulation/cut_events.h"

namespace tactooth {

/// The place on the walls of the cut, nearest to `tip` and at most 6 mm from it, where pulp lies open.
[[nodiscard]] std::optional<Vec3> nearestPulp(const Surface& tooth, const MaterialRegistry& materials, const Vec3& tip);

/// Where the pulp bleeds: follows the events of a cut and the surface, and keeps the place as long as the event counts.
class PulpOpening {
public:
    /// `tooth`: its surface now, tags: MaterialId.
    void follow(const CutEvents& events, const Surface& tooth, const MaterialRegistry& materials);
    /// None: the pulp is closed. Tooth frame.
    [[nodiscard]] const std::optional<Vec3>& place() const { return place_; }

private:
    std::optional<Vec3> place_;
    double time_ = 0;  // of the event
    bool isOnSurface_ = false;
    std::pair<std::uint64_t, std::uint64_t> searched_;  // surface: id of its base, revision
};

}  // namespace tactooth
