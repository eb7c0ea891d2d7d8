// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include "collision/bvh/surface.h"
#include "tooth/volume/brick_key.h"
#include "tooth/volume/lattice.h"

namespace tactooth {

/// A region that is removed from a tooth, given by how deep each place lies in it. Tooth frame, mm.
class RemovedBody {
public:
    /// How deep a place lies in the region: about the distance to its boundary, negative outside.
    struct Depth {
        double value;   ///< mm
        Vec3 gradient;  ///< into the region; not zero
    };
    virtual ~RemovedBody() = default;
    RemovedBody() = default;
    RemovedBody(const RemovedBody&) = default;
    RemovedBody(RemovedBody&&) = default;
    RemovedBody& operator=(const RemovedBody&) = default;
    RemovedBody& operator=(RemovedBody&&) = default;

    /// Called from several threads. Two values differ by at most kSteepest times the distance of their places.
    [[nodiscard]] virtual Depth depthAt(const Vec3& place) const = 0;
    /// Holds the part of the region that lies in the tooth.
    [[nodiscard]] virtual Box3 box() const = 0;

    static constexpr double kSteepest = 1.6;
};

/// How deep a place lies in the union of two regions. The edge of tooth that stays between them is rounded with the
/// radius `wanted`, mm; 0: it is sharp. An edge below a right angle has a smaller radius, the sharper the smaller, so
/// that a thin blade stays. Both gradients have a length of about 1.
[[nodiscard]] RemovedBody::Depth unitedRound(const RemovedBody::Depth& a, const RemovedBody::Depth& b, double wanted);

/// The cut of a volume of this lattice that removes the body from the tooth `outer` (closed, uncut), as
/// CutModel::adopt takes it. Holds no bricks that the body or the tooth is clear of.
[[nodiscard]] std::map<BrickKey, CutField> cutFieldsOf(const RemovedBody& body, const SurfacePart& outer,
                                                       const Lattice& lattice);

}  // namespace tactooth
