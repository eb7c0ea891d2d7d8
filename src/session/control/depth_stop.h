// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/pose.h"
#include "session/control/depth_control.h"

namespace tactooth {

/// A depth stop for a hand that feels force: a virtual fixture (L. B. Rosenberg 1993). It holds the tool at the floor
/// of a cavity while the device goes deeper, and pushes the device back along the shaft with a spring and a damper.
/// What is simulated and recorded is the tool that was held. Servo thread only; does not allocate or lock.
class DepthStop {
public:
    /// The pose of the tool for a device that holds it at `wanted`, `elapsed` s after the last call. `control`: where
    /// the floor is; null: there is none. `proxy`: the tip of the tool as the tooth lets it be; it is pressed a little
    /// beyond the floor until it is there, else the force would fade with the distance. Null: nobody knows. A floor
    /// that appears above the tool lifts it slowly.
    [[nodiscard]] Pose hold(const Pose& wanted, const DepthControl* control, double elapsed,
                            const Vec3* proxy = nullptr);

    /// How far the device is beyond the tool, mm.
    [[nodiscard]] double beyond() const { return beyond_; }
    /// On the device, N, tooth frame: along the shaft, out of the tooth.
    [[nodiscard]] const Vec3& force() const { return force_; }

    static constexpr double kStiffness = 1.0;  ///< N/mm: what desktop arms render stably, and softer than enamel
    static constexpr double kDamping = 0.001;  ///< N s/mm, against going deeper

private:
    [[nodiscard]] double next(const Pose& wanted, const DepthControl* control, double elapsed, const Vec3* proxy) const;

    Vec3 last_ = Vec3::Zero();  // position of the device at the last call
    bool hasLast_ = false;
    double beyond_ = 0;
    Vec3 force_ = Vec3::Zero();
};

}  // namespace tactooth
