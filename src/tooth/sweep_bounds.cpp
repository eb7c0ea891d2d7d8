// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A quick look at many nodes before the exact one at few: most nodes near a bur keep the distance that they have, and
// single precision is enough to prove it.
#include <limits>

#include "collision/simd8.h"
#include "tooth/swept_envelope.h"

namespace tactooth {
namespace {

/// Of the size of the coordinates; what single precision may hide in a distance. Four times its rounding, four deep.
constexpr double kRounding = 2e-6;
/// mm; nearer than this the offset to the envelope has no direction.
constexpr float kNoDirection = 1e-4F;

/// Lanes are nodes (x, y) = (0..3, y..y+1).
constexpr float kLaneX[8] = {0, 1, 2, 3, 0, 1, 2, 3};
constexpr float kLaneY[8] = {0, 0, 0, 0, 1, 1, 1, 1};

/// Places of a block's nodes in a tool frame.
struct BlockInTool {
    Vec3 first;
    Mat3 steps;  ///< columns: from one node to the next on each axis
    [[nodiscard]] Vec3x8 lanes(int y, int z) const {
        const Vec3 row = first + y * steps.col(1) + z * steps.col(2);
        const auto axis = [&](int i) {
            return Float8::all(static_cast<float>(row[i])) +
                   Float8::load(kLaneX) * Float8::all(static_cast<float>(steps(i, 0))) +
                   Float8::load(kLaneY) * Float8::all(static_cast<float>(steps(i, 1)));
        };
        return {axis(0), axis(1), axis(2)};
    }
};

struct Samples8 {
    Float8 distance;
    Float8 sinking;  ///< how fast the distance grows along the path given, at least 0
};

Samples8 sampleLanes(const ProfilePart& part, const Vec3x8& point, const Vec3x8& path, Float8 pathLength) {
    const Float8 zero = Float8::all(0);
    const Float8 squaredRadius = point.x * point.x + point.y * point.y;
    const Float8 radius = sqrt(squaredRadius);
    Float8 best = Float8::all(std::numeric_limits<float>::max());
    Float8 offsetR = zero;
    Float8 offsetZ = zero;
    for (int i = 0; i < part.pieceCount; ++i) {
        const ProfilePart::Piece& piece = part.pieces[i];
        const Float8 directionR = Float8::all(piece.directionR);
        const Float8 directionZ = Float8::all(piece.directionZ);
        const Float8 dr = radius - Float8::all(piece.radius);
        const Float8 dz = point.z - Float8::all(piece.z);
        const Float8 along = min(max(dr * directionR + dz * directionZ, zero), Float8::all(piece.length));
        const Float8 awayR = dr - along * directionR;
        const Float8 awayZ = dz - along * directionZ;
        const Float8 squared = awayR * awayR + awayZ * awayZ;
        offsetR = whereLess(squared, best, awayR, offsetR);
        offsetZ = whereLess(squared, best, awayZ, offsetZ);
        best = min(best, squared);
    }
    Float8 outside = Float8::all(1);
    for (int i = 0; i < part.spanCount; ++i) {
        const ProfilePart::Span& span = part.spans[i];
        const Float8 above = point.z - Float8::all(span.low);
        const Float8 beyond = radius - (Float8::all(span.radius) + above * Float8::all(span.growth));
        outside = min(outside, max(max(zero - above, point.z - Float8::all(span.high)), beyond));
    }
    const Float8 distance = sqrt(best);
    const Float8 sign = whereLess(outside, zero, Float8::all(-1), Float8::all(1));
    const Float8 outward = point.x * path.x + point.y * path.y;
    const Float8 least = Float8::all(kNoDirection);
    const Float8 slope = sign * (offsetR * outward / max(radius, least) + offsetZ * path.z) / max(distance, least);
    const Float8 sinking = max(slope, zero);
    return {sign * distance, whereLess(min(distance, radius), least, pathLength, min(sinking, pathLength))};
}

}  // namespace

void SweepStep::boundBlock(const Vec3& corner, double spacing, BlockBounds& bounds) const {
    const BlockInTool end{to_.toTool(corner), spacing * to_.toolFromTooth};
    const BlockInTool start{from_.toTool(corner), spacing * from_.toolFromTooth};
    const Vec3 middle = end.first + end.steps * Vec3::Constant(0.5 * (kBlockSide - 1));
    const double reach = 0.5 * (kBlockSide - 1) * std::sqrt(3.0) * spacing;
    ProfilePart part;
    if (!envelope_->findPart(middle, reach * (1 + kRounding), part)) {
        bounds.lower.fill(-std::numeric_limits<float>::max());
        bounds.upper.fill(std::numeric_limits<float>::max());
        return;
    }
    const double hidden = kRounding * (1 + middle.cwiseAbs().maxCoeff() + start.first.cwiseAbs().maxCoeff());
    const Float8 below = Float8::all(static_cast<float>(clearance_ + hidden));
    const Float8 above = Float8::all(static_cast<float>(clearance_ - hidden));
    const Float8 pathLength = Float8::all(static_cast<float>(travel_));
    for (int z = 0; z < kBlockSide; ++z) {
        for (int y = 0; y < kBlockSide; y += 2) {
            const Vec3x8 point = end.lanes(y, z);
            const Samples8 samples = sampleLanes(part, point, point - start.lanes(y, z), pathLength);
            const int first = kBlockSide * (y + kBlockSide * z);
            (samples.distance - samples.sinking - below).store(bounds.lower.data() + first);
            (samples.distance - above).store(bounds.upper.data() + first);
        }
    }
}

}  // namespace tactooth
