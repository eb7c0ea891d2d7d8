// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/preparation_metrics.h"

#include <algorithm>
#include <array>

namespace tactooth {
namespace {

constexpr double kSpacing = 0.05;  // mm between two lines of the volumes: 0.2 % of a cavity of 4 x 3 mm

using All = const PreparationMeasures&;

constexpr std::array kMetrics = {
    PreparationMetric{"cleared_share", "Ideal preparation cut", "1", Better::Higher,
                      [](All m) { return Measured::of(m.volumes.clearedShare()); },
                      "Removed share of the volume that was to be removed."},
    PreparationMetric{"over_max", "Deepest over-preparation", "mm", Better::Lower,
                      [](All m) { return m.deviation.overMax; },
                      "Greatest distance of the cut surface beyond the ideal surface."},
    PreparationMetric{"over_volume", "Over-prepared volume", "mm^3", Better::Lower,
                      [](All m) { return Measured::of(m.volumes.over); }, "Removed volume that was not to be removed."},
    PreparationMetric{"under_volume", "Under-prepared volume", "mm^3", Better::Lower,
                      [](All m) { return Measured::of(m.volumes.under); },
                      "Volume that was to be removed and is still there."},
    PreparationMetric{"dice", "Overlap (Dice)", "1", Better::Higher,
                      [](All m) { return Measured::of(m.volumes.dice()); },
                      "Twice the common volume of the removed and the ideal part over the sum of both (Dice 1945)."},
    PreparationMetric{"deviation_rms", "Deviation from the ideal surface (RMS)", "mm", Better::Lower,
                      [](All m) { return m.deviation.rms; },
                      "Root mean square, by area, of the distance to the ideal surface, where one of the two is cut."},
    PreparationMetric{"within_0_1", "Surface within 0.1 mm", "1", Better::Higher,
                      [](All m) { return m.deviation.within[0]; },
                      "Share of that area within 0.1 mm of the ideal surface."},
    PreparationMetric{"within_0_2", "Surface within 0.2 mm", "1", Better::Higher,
                      [](All m) { return m.deviation.within[1]; },
                      "Share of that area within 0.2 mm of the ideal surface."},
    PreparationMetric{"within_0_3", "Surface within 0.3 mm", "1", Better::Higher,
                      [](All m) { return m.deviation.within[2]; },
                      "Share of that area within 0.3 mm of the ideal surface."},
    PreparationMetric{"within_0_4", "Surface within 0.4 mm", "1", Better::Higher,
                      [](All m) { return m.deviation.within[3]; },
                      "Share of that area within 0.4 mm of the ideal surface."},
    PreparationMetric{"floor_depth_median", "Depth of the floor (median)", "mm", Better::Neither,
                      [](All m) { return m.form.floorDepth; },
                      "Median, by area, of the distance along the axis from the floor to the uncut surface."},
    PreparationMetric{"floor_flatness", "Flatness of the floor (RMS)", "mm", Better::Lower,
                      [](All m) { return m.form.floorFlatness; },
                      "Root mean square distance of the floor from its plane (total least squares)."},
    PreparationMetric{"floor_tilt", "Tilt of the floor", "deg", Better::Lower, [](All m) { return m.form.floorTilt; },
                      "Angle between the normal of that plane and the axis."},
    PreparationMetric{"wall_angle_b", "Buccal wall", "deg", Better::Neither, [](All m) { return m.form.wallAngle[0]; },
                      "Mean angle of the buccal wall to the axis; positive: narrower at the outer end."},
    PreparationMetric{"wall_angle_l", "Lingual wall", "deg", Better::Neither, [](All m) { return m.form.wallAngle[1]; },
                      "The same of the lingual wall."},
    PreparationMetric{"wall_angle_m", "Mesial wall", "deg", Better::Neither, [](All m) { return m.form.wallAngle[2]; },
                      "The same of the mesial wall."},
    PreparationMetric{"wall_angle_d", "Distal wall", "deg", Better::Neither, [](All m) { return m.form.wallAngle[3]; },
                      "The same of the distal wall."},
    PreparationMetric{"extent_md", "Length, mesiodistal", "mm", Better::Neither,
                      [](All m) { return m.extent.mesiodistal; },
                      "Length of the cut surface in the mesiodistal direction of the tooth."},
    PreparationMetric{"extent_bl", "Width, buccolingual", "mm", Better::Neither,
                      [](All m) { return m.extent.buccolingual; }, "The same in the buccolingual direction."},
    PreparationMetric{"extent_og", "Height, occlusogingival", "mm", Better::Neither,
                      [](All m) { return m.extent.vertical; }, "The same along the tooth's long axis."},
    PreparationMetric{"isthmus_min", "Isthmus, narrowest", "mm", Better::Neither,
                      [](All m) { return m.extent.isthmus; },
                      "Smallest width of the cavity across its longest direction, without both ends."},
    PreparationMetric{"ridge_min_m", "Mesial ridge left", "mm", Better::Neither,
                      [](All m) { return m.extent.mesialRidge; },
                      "Smallest distance from the cut surface to the mesial outside of the uncut tooth."},
    PreparationMetric{"ridge_min_d", "Distal ridge left", "mm", Better::Neither,
                      [](All m) { return m.extent.distalRidge; }, "The same to the distal outside."},
    PreparationMetric{"undercut_area", "Undercut area", "mm^2", Better::Neither, [](All m) { return m.undercut.area; },
                      "Cut area that faces away from the axis by more than 1 degree, or that something hangs over."},
    PreparationMetric{"undercut_depth", "Undercut depth", "mm", Better::Neither, [](All m) { return m.undercut.depth; },
                      "Greatest level distance from a cut wall to the end of what hangs over it."},
    PreparationMetric{"toc_md", "Convergence, mesiodistal", "deg", Better::Neither,
                      [](All m) { return m.form.tocMesiodistal; },
                      "Total occlusal convergence of a crown preparation: angle of the mesial plus the distal wall."},
    PreparationMetric{"toc_bl", "Convergence, buccolingual", "deg", Better::Neither,
                      [](All m) { return m.form.tocBuccolingual; }, "The same of the buccal and the lingual wall."},
    PreparationMetric{"remaining_dentin_min", "Dentin left over the pulp", "mm", Better::Higher,
                      [](All m) { return m.damage.remainingDentin; },
                      "Smallest distance from the cut surface to the pulp; 0 where it is open."},
    PreparationMetric{"pulp_open", "Pulp opened", "1", Better::Lower, [](All m) { return m.damage.pulpOpen; },
                      "1 if the cut surface reaches the pulp, else 0."},
    PreparationMetric{"neighbour_depth_max", "Deepest cut in a neighbour", "mm", Better::Lower,
                      [](All m) { return m.damage.neighbourDepth; },
                      "Greatest depth of a cut below the surface of a tooth beside."},
};

}  // namespace

PreparationMeasures::PreparationMeasures(const Preparation& preparation)
    : surfaces(preparation),
      form(cavityForm(preparation, surfaces)),
      extent(cavityExtent(preparation, surfaces)),
      undercut(tactooth::undercut(preparation, surfaces)),
      damage(tissueDamage(preparation, surfaces)) {
    const ColumnGrid columns(preparation.axis, surfaces.cut.mesh, surfaces.idealCut.mesh, kSpacing);
    volumes = preparedVolumes(preparation, columns);
    deviation = surfaceDeviation(preparation, columns);
}

std::span<const PreparationMetric> preparationMetrics() { return kMetrics; }

const PreparationMetric* findPreparationMetric(std::string_view id) {
    const auto* const found = std::ranges::find(kMetrics, id, &PreparationMetric::id);
    return found == kMetrics.end() ? nullptr : found;
}

std::vector<MetricResult> measureAll(const PreparationMeasures& measures) {
    std::vector<MetricResult> results;
    for (const PreparationMetric& metric : preparationMetrics()) results.push_back({&metric, metric.measure(measures)});
    return results;
}

}  // namespace tactooth
