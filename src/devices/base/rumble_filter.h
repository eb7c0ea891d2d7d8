// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// Splits a force into a steady part and a vibration part for the two motors of a gamepad. The heavy motor renders the
/// steady force, the light one the quick changes (a cutting bur, a tap).
class RumbleFilter {
public:
    /// `force`: N. `elapsed`: s since the previous call.
    void add(const Vec3& force, double elapsed);
    [[nodiscard]] double steady() const { return steady_.norm(); }
    /// Root mean square of the quick changes, N.
    [[nodiscard]] double vibration() const;

private:
    Vec3 steady_ = Vec3::Zero();
    double square_ = 0;
};

}  // namespace tactooth
