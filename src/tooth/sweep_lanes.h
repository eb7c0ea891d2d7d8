// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/simd8.h"
#include "tooth/swept_envelope.h"

namespace tactooth {

/// Eight of SweepStep's samples: distances in mm, unit gradients in the tooth frame.
struct Samples8 {
    Float8 distance;
    Vec3x8 gradient;
};

/// One step of a sweep as a small cube of lattice nodes sees it: eight points at a time in single precision. Heights
/// count from the middle of the cube, so that what a float rounds away is below 1e-6 mm.
class SweepLanes {
public:
    /// The cube begins at the node at `first` (tooth frame) and is `side` steps of `spacing` wide; points may lie
    /// `beyond` more steps outside it. The step outlives this. `middle`: the step as seen from the cube's middle.
    SweepLanes(const SweepStep& step, const Vec3& first, double spacing, double side, double beyond,
               const SweepStep::Look& middle);
    SweepLanes(const SweepStep& step, const Vec3& first, double spacing, double side, double beyond)
        : SweepLanes(step, first, spacing, side, beyond, step.lookFrom(first + Vec3::Constant(0.5 * side * spacing))) {}

    /// SweepStep::sample at places within the cube, told in steps from its first node.
    [[nodiscard]] Samples8 sample(const Vec3x8& place, Float8 atLeast) const;

private:
    /// From places in the cube to the tool frame.
    struct Frame {
        float first[3];
        float steps[3][3];  ///< by axis of the tool, then of the lattice
        [[nodiscard]] Vec3x8 at(const Vec3x8& place) const;
    };
    struct Profile8;
    [[nodiscard]] static Frame frame(const Vec3& first, const Mat3& steps, double level);
    [[nodiscard]] Profile8 sampleProfile(const Vec3x8& point) const;
    [[nodiscard]] Samples8 sampleOneByOne(const Vec3x8& place, Float8 atLeast) const;

    const SweepStep& step_;
    Vec3 first_;
    double spacing_;
    Frame from_;
    Frame to_;
    ProfilePart part_;
    bool hasPart_;
};

}  // namespace tactooth
