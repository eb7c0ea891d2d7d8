// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "assessment/preparation/measured.h"
#include "assessment/preparation/preparation.h"
#include "session/track/session_track.h"

namespace tactooth {

/// Places on the head of a bur that stand for it, in its frame: rings of eight, 0.3 mm apart, up to 4 mm above its end.
[[nodiscard]] std::vector<Vec3> headPlaces(const RevolutionEnvelope& head);

/// What an ideal preparation removes.
class TargetRegion {
public:
    /// The surfaces are those of a Preparation and of its CutSurfaces.
    TargetRegion(std::shared_ptr<const SurfacePart> original, std::shared_ptr<const SurfacePart> ideal,
                 const TriangleMesh& idealWalls)
        : original_(std::move(original)), ideal_(std::move(ideal)), walls_(idealWalls) {}

    /// How far a bur whose head has these places works beside the target, mm: how deep it lies in the tooth that is to
    /// stay, or, where nothing of it lies in the target, at least its distance from the target.
    [[nodiscard]] double beyond(std::span<const Vec3> places) const;

private:
    [[nodiscard]] bool isInTarget(const Vec3& place) const;
    [[nodiscard]] double toTarget(const Vec3& place) const;

    std::shared_ptr<const SurfacePart> original_, ideal_;
    SurfacePart walls_;
};

/// Shares of the time of drilling, 0..1; their sum is 1.
struct BurCoverage {
    Measured target;   ///< no more than 0.05 mm, the spacing of the cut volume, beside the target
    Measured band;     ///< more, but within the tolerance
    Measured outside;  ///< beyond it
};
/// `sessionInTooth`: pose of the session's tooth in the frame of the preparation. Takes about a second. The same on any
/// number of threads.
[[nodiscard]] BurCoverage burCoverage(const Preparation& preparation, const CutSurfaces& surfaces,
                                      const SessionTrack* track, const Pose& sessionInTooth = {});

}  // namespace tactooth
