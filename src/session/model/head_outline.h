// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "session/model/session_bur.h"

namespace tactooth {

/// The outline of a bur's head as it looks from outside: its silhouette.
class HeadOutline {
public:
    static constexpr int kPlaces = 32;

    explicit HeadOutline(const SessionBur& bur);
    /// `length`: of the head, from the tip, mm; 0: the whole bur.
    HeadOutline(const RevolutionEnvelope& bur, double length);

    /// The outline seen along `inward`, unit, of a tool that is turned by `tool`: kPlaces places at equal distances,
    /// from the tip of the bur, in the plane square to `inward`, mm. It is convex, so it spans the waist of a head.
    [[nodiscard]] std::vector<Vec3> seenAlong(const Vec3& inward, const Quat& tool) const;
    /// The largest radius of the head, mm.
    [[nodiscard]] double radius() const { return radius_; }

private:
    std::vector<RevolutionEnvelope::ProfilePoint> rings_;
    double radius_ = 0;
};

}  // namespace tactooth
