// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/narrow/simd8.h"
#include "tooth/sweep/swept_envelope.h"

namespace tactooth {

/// Eight samples of SweepStep: distances in mm, unit gradients in the tooth frame.
struct Samples8 {
    Float8 distance;
    Vec3x8 gradient;
};

/// One step of a sweep, prepared for a small cube of lattice nodes: eight points at a time in single precision. Heights
/// count from the middle of the cube, so that rounding to floats costs less than 1e-6 mm.
class SweepLanes {
public:
    /// The cube begins at the node at `first` (tooth frame) and is `side` steps of `spacing` wide. Points may lie up to
    /// `beyond` steps outside it. The step must outlive this. `middle` is the query of the step at the middle of the
    /// cube.
    SweepLanes(const SweepStep& step, const Vec3& first, double spacing, double side, double beyond,
               const SweepStep::MidpointQuery& middle);
    SweepLanes(const SweepStep& step, const Vec3& first, double spacing, double side, double beyond)
        : SweepLanes(step, first, spacing, side, beyond, step.queryFrom(first + Vec3::Constant(0.5 * side * spacing))) {
    }

    /// SweepStep::sample at places in the cube, in steps from its first node.
    [[nodiscard]] Samples8 sample(const Vec3x8& place, Float8 atLeast) const;

    /// False if `sample` finds no distance below `atLeast` at any place. Where the envelope is convex, no distance is
    /// smaller than that to the tangent plane at the middle of the cube.
    [[nodiscard]] bool mayReach(const Vec3x8& place, Float8 atLeast) const {
        return !part_.bulges || (lessEqual(atLeast, min(planeFrom_.at(place), planeTo_.at(place))) & 0xFFU) != 0xFFU;
    }

private:
    /// Maps places in the cube to the tool frame.
    struct Frame {
        float first[3];
        float steps[3][3];  ///< by axis of the tool, then axis of the lattice
        [[nodiscard]] Vec3x8 at(const Vec3x8& place) const;
    };
    /// A distance that is linear in the place.
    struct Plane {
        float first;
        float steps[3];
        [[nodiscard]] Float8 at(const Vec3x8& place) const {
            return Float8::all(first) + place.x * Float8::all(steps[0]) + place.y * Float8::all(steps[1]) +
                   place.z * Float8::all(steps[2]);
        }
    };
    struct Profile8;
    struct Search;
    [[nodiscard]] static Frame frame(const Vec3& first, const Mat3& steps, double level);
    [[nodiscard]] Profile8 sampleProfile(const Vec3x8& point) const;
    void searchPart(const Vec3x8& start, const Vec3x8& end, float first, float last, Search& search) const;
    [[nodiscard]] Samples8 sampleOneByOne(const Vec3x8& place, Float8 atLeast) const;

    const SweepStep& step_;
    Vec3 first_;
    double spacing_;
    Frame from_;
    Frame to_;
    Plane planeFrom_;  ///< at the start and at the end of the step
    Plane planeTo_;
    ProfilePart part_;
    bool hasPart_;
    int searchedParts_;  ///< 1 if the distance is convex along the whole step
};

}  // namespace tactooth
