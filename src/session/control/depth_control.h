// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "collision/bvh/surface.h"

namespace tactooth {

/// The floor of a cavity that is cut to a set depth.
enum class CavityFloor {
    FollowsSurface,  ///< everywhere as deep below the uncut surface
    Flat,            ///< in one plane across the axis of the tool
};

/// Measures depths below the uncut surface of a tooth along the axis of the tool, and says how far the tool may still
/// go. Tooth frame, mm. Directions are unit vectors that point into the tooth.
class DepthControl {
public:
    /// The uncut surface; null: there is none, and nothing has a depth.
    void setSurface(std::shared_ptr<const SurfacePart> uncut);
    /// That surface; none: there is none.
    [[nodiscard]] const std::optional<Surface>& surface() const { return uncut_; }

    /// Depth of the floor, clamped to 0..kMaxDepth.
    void setDepth(double depth);
    [[nodiscard]] double depth() const { return depth_; }
    static constexpr double kMaxDepth = 8;      ///< mm: the floor of the pulp chamber of any molar
    static constexpr double kUsualDepth = 1.5;  ///< mm: just through the enamel of a fissure

    void setFloor(CavityFloor floor);
    [[nodiscard]] CavityFloor floor() const { return floor_; }
    /// The place from whose height the depth of a flat floor counts. It stays until another one is set; none: the next
    /// call of beginAt sets it.
    void setReference(const std::optional<Vec3>& place);
    /// The tool begins to press over `tip`. The depth of a flat floor counts from the uncut surface there, unless an
    /// earlier place holds: that of an exercise, or that of the cavity that the tip is in.
    void beginAt(const Vec3& tip, const Vec3& inward);

    /// Depth of `tip` below the uncut surface, negative above it. None where the line through it misses the tooth.
    [[nodiscard]] std::optional<double> depthOf(const Vec3& tip, const Vec3& inward) const;
    /// How far `tip` may go on until it is at the floor; negative if it is deeper. None where nothing has a depth.
    [[nodiscard]] std::optional<double> toFloor(const Vec3& tip, const Vec3& inward) const;

private:
    std::optional<Surface> uncut_;
    double depth_ = kUsualDepth;
    CavityFloor floor_ = CavityFloor::FollowsSurface;
    std::optional<Vec3> reference_;
    bool isReferenceSet_ = false;  // by somebody else than beginAt
};

}  // namespace tactooth
