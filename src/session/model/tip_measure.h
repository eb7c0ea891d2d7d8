// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "session/model/head_outline.h"
#include "session/model/session_model.h"
#include "session/simulation/pulp_distance.h"

namespace tactooth {

/// What somebody who cuts must know about the tip of the bur.
struct TipMeasure {
    std::optional<double> depth;  ///< of the tip below the uncut surface, mm, negative above it; none beside the tooth
    std::optional<double>
        overPulp;      ///< mm of tooth between bur and pulp, negative in the pulp; none: far away, no pulp
    double force = 0;  ///< N
    /// Of a periodontal probe in a cavity: how deep its tip stands below the uncut surface, along the probe, mm; what
    /// its rings show there. None: another instrument, or outside.
    std::optional<double> probed;
    double hold = 0;  ///< the force that draws an explorer's tip out of soft decay, N; 0: nothing holds it
};

/// How dangerous the place of the bur is.
enum class TipWarning {
    None,
    Deep,      ///< more than kToleratedDepth deeper than was set, in PressMode::Depth
    NearPulp,  ///< less than kNearPulp over the pulp
    AtPulp,    ///< less than kAtPulp over the pulp: stop
};
inline constexpr double kToleratedDepth = 0.15;  ///< mm

/// What a periodontal probe reads at this pose; none where its tip stands outside the uncut surface.
[[nodiscard]] std::optional<double> probedDepth(const DepthControl& depths, const Pose& probe);

/// Of the newest tick. Needs a runner. Fast enough for each picture.
[[nodiscard]] TipMeasure tipMeasure(const SessionModel& model);
[[nodiscard]] TipWarning warningOf(const TipMeasure& measure, const SessionModel& model);

/// A place of the outline of a bur that will land.
struct AimPlace {
    Vec3 at = Vec3::Zero();
    /// The bur will touch a neighbour or a gum here before it is as deep as it is to go.
    bool touchesBeside = false;
};

/// Where the bur will land, for a picture: the outline of its head, seen along the press direction, on the surface
/// below it.
struct AimMark {
    Vec3 tip = Vec3::Zero();
    std::optional<Vec3> landing;  ///< below the tip along the press direction; none beside the tooth
    /// The outline, closed; a place that misses the tooth is left out.
    std::vector<AimPlace> ring;

    [[nodiscard]] bool touchesBeside() const;
};

/// For a bur that the mouse's hand holds at `tool`. In a cavity the ring lies at the height of its rim.
[[nodiscard]] AimMark aimMark(const MouseManipulator& hand, const HeadOutline& head, const Pose& tool);

}  // namespace tactooth
