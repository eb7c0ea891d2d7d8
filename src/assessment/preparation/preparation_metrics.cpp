// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/preparation_metrics.h"

#include <algorithm>
#include <array>

#include "assessment/messages.h"
#include "assessment/preparation/enamel_support.h"

namespace tactooth {
namespace {

constexpr double kSpacing = 0.05;  // mm between two lines of the volumes: 0.2 % of a cavity of 4 x 3 mm

using All = const PreparationMeasures&;

Measured noHand(All m) { return Measured::none(m.hasSession ? msg::kNeverTouched : msg::kNoSession); }
Measured ofHand(All m, double HandWork::*value) { return m.hand ? Measured::of((*m.hand).*value) : noHand(m); }
Measured ofHand(All m, Measured HandWork::*value) { return m.hand ? (*m.hand).*value : noHand(m); }

Measured efficiency(All m) {
    if (!m.hand) return noHand(m);
    if (!(m.hand->drilling > 0)) return Measured::none(msg::kNeverDrilled);
    return Measured::of(m.volumes.common / m.hand->drilling);
}

constexpr std::array kMetrics = {
    PreparationMetric{"cleared_share", "Ideal preparation cut", "1", Better::Higher,
                      [](All m) { return Measured::of(m.volumes.clearedShare()); },
                      "Removed share of the volume that was to be removed.", ValueForm::Share},
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
                      "Twice the common volume of the removed and the ideal part over the sum of both (Dice 1945).",
                      ValueForm::Share},
    PreparationMetric{"deviation_rms", "Deviation from the ideal (RMS)", "mm", Better::Lower,
                      [](All m) { return m.deviation.rms; },
                      "Root mean square, by area, of the distance to the ideal surface, where one of the two is cut."},
    PreparationMetric{"within_0_1", "Surface within 0.1 mm", "1", Better::Higher,
                      [](All m) { return m.deviation.within[0]; },
                      "Share of that area within 0.1 mm of the ideal surface.", ValueForm::Share},
    PreparationMetric{"within_0_2", "Surface within 0.2 mm", "1", Better::Higher,
                      [](All m) { return m.deviation.within[1]; },
                      "Share of that area within 0.2 mm of the ideal surface.", ValueForm::Share},
    PreparationMetric{"within_0_3", "Surface within 0.3 mm", "1", Better::Higher,
                      [](All m) { return m.deviation.within[2]; },
                      "Share of that area within 0.3 mm of the ideal surface.", ValueForm::Share},
    PreparationMetric{"within_0_4", "Surface within 0.4 mm", "1", Better::Higher,
                      [](All m) { return m.deviation.within[3]; },
                      "Share of that area within 0.4 mm of the ideal surface.", ValueForm::Share},
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
                      "1 if the cut surface reaches the pulp, else 0.", ValueForm::Count},
    PreparationMetric{"neighbour_depth_max", "Deepest cut in a neighbour", "mm", Better::Lower,
                      [](All m) { return m.damage.neighbourDepth; },
                      "Greatest depth of a cut below the surface of a tooth beside."},
    PreparationMetric{"unsupported_enamel", "Unsupported enamel", "mm^2", Better::Lower,
                      [](All m) { return m.unsupportedEnamel; },
                      "Area of cut enamel below which, square to the uncut surface, there is no dentin."},
    PreparationMetric{"finish_line_roughness", "Roughness of the margin (RMS)", "mm", Better::Lower,
                      [](All m) { return m.margin.roughness; },
                      "RMS distance of the margin, or finish line, from itself when smoothed over 0.5 mm."},
    PreparationMetric{"finish_line_width", "Width of the finish line (median)", "mm", Better::Neither,
                      [](All m) { return m.margin.width; },
                      "From the finish line of a crown preparation to the axial wall, square to the axis."},
    PreparationMetric{"finish_line_width_sd", "Unevenness of that width", "mm", Better::Lower,
                      [](All m) { return m.margin.widthSpread; }, "Standard deviation of that width."},
    PreparationMetric{"removed_enamel", "Enamel removed", "mm^3", Better::Neither,
                      [](All m) { return m.tissues.removedEnamel; }, "Volume of enamel that was removed."},
    PreparationMetric{"removed_dentin", "Dentin removed", "mm^3", Better::Neither,
                      [](All m) { return m.tissues.removedDentin; }, "Volume of dentin that was removed."},
    PreparationMetric{"removed_pulp", "Pulp removed", "mm^3", Better::Neither,
                      [](All m) { return m.tissues.removedPulp; }, "Volume of pulp that was removed."},
    PreparationMetric{"removed_decay", "Decay removed", "mm^3", Better::Higher,
                      [](All m) { return m.tissues.removedDecay; }, "Volume of decay that was removed."},
    PreparationMetric{"decay_left", "Decay left", "mm^3", Better::Lower, [](All m) { return m.tissues.decayLeft; },
                      "Volume of decay that is still in the tooth."},
    PreparationMetric{"decay_share", "Decay removed, share", "1", Better::Higher,
                      [](All m) { return m.tissues.decayShare; }, "Removed share of all decay.", ValueForm::Share},
    PreparationMetric{"over_enamel", "Sound enamel over-prepared", "mm^3", Better::Lower,
                      [](All m) { return m.tissues.overEnamel; }, "Removed enamel that was not to be removed."},
    PreparationMetric{"over_dentin", "Sound dentin over-prepared", "mm^3", Better::Lower,
                      [](All m) { return m.tissues.overDentin; }, "Removed dentin that was not to be removed."},
    PreparationMetric{"session_time", "Length of the session", "s", Better::Neither,
                      [](All m) { return ofHand(m, &HandWork::seconds); },
                      "From the first to the last moment of the recording."},
    PreparationMetric{"drilling_time", "Drilling", "s", Better::Neither,
                      [](All m) { return ofHand(m, &HandWork::drilling); },
                      "Time in which the turning bur touches something."},
    PreparationMetric{"idle_time", "Idle spinning", "s", Better::Lower,
                      [](All m) { return ofHand(m, &HandWork::idle); },
                      "Time in which the bur turns and touches nothing."},
    PreparationMetric{"dead_time", "Pauses", "s", Better::Neither, [](All m) { return ofHand(m, &HandWork::dead); },
                      "Time without turning and touching, in pauses of more than 1 s."},
    PreparationMetric{"path_length", "Path of the bur", "mm", Better::Lower,
                      [](All m) { return ofHand(m, &HandWork::path); },
                      "Length of the path of the bur's tip, without what is faster than 20 Hz."},
    PreparationMetric{"strokes", "Strokes", "1", Better::Neither, [](All m) { return ofHand(m, &HandWork::strokes); },
                      "Contacts of the turning bur of more than 50 ms; gaps of less than 50 ms do not count.",
                      ValueForm::Count},
    PreparationMetric{"stroke_time", "Length of a stroke (median)", "s", Better::Neither,
                      [](All m) { return ofHand(m, &HandWork::strokeTime); }, "Median of their durations."},
    PreparationMetric{"sparc", "Smoothness (SPARC, median)", "1", Better::Higher,
                      [](All m) { return ofHand(m, &HandWork::arcLength); },
                      "Spectral arc length of the speed in strokes of more than 0.3 s (Balasubramanian 2012)."},
    PreparationMetric{"ldlj", "Smoothness (LDLJ, median)", "1", Better::Higher,
                      [](All m) { return ofHand(m, &HandWork::jerk); },
                      "Log dimensionless jerk of the speed in the same strokes (Balasubramanian 2015)."},
    PreparationMetric{"speed_f95", "95 % frequency of the speed", "Hz", Better::Lower,
                      [](All m) { return ofHand(m, &HandWork::frequency95); },
                      "Frequency below which 95 % of the power of the speed lies, in the same strokes."},
    PreparationMetric{"force_mean", "Force, mean", "N", Better::Neither,
                      [](All m) { return ofHand(m, &HandWork::forceMean); }, "Mean force over the time of contact."},
    PreparationMetric{"force_p95", "Force, 95 % below", "N", Better::Lower,
                      [](All m) { return ofHand(m, &HandWork::forceP95); },
                      "Force that is not exceeded in 95 % of the time of contact."},
    PreparationMetric{"force_peak", "Force, greatest", "N", Better::Lower,
                      [](All m) { return ofHand(m, &HandWork::forcePeak); }, "Greatest force."},
    PreparationMetric{"force_over_2n", "Time with more than 2 N", "1", Better::Lower,
                      [](All m) { return ofHand(m, &HandWork::forceOver2); },
                      "Share of the time of contact with more than 2 N.", ValueForm::Share},
    PreparationMetric{"force_sd", "Force, unsteadiness in strokes", "N", Better::Lower,
                      [](All m) { return ofHand(m, &HandWork::forceSpread); },
                      "Standard deviation of the force within a stroke: root mean square over the strokes, by time."},
    PreparationMetric{"impulse", "Impulse", "N*s", Better::Neither, [](All m) { return ofHand(m, &HandWork::impulse); },
                      "Force times time, summed over all contacts."},
    PreparationMetric{"efficiency", "Efficiency", "mm^3/s", Better::Higher, [](All m) { return efficiency(m); },
                      "Removed volume that was to be removed, for each second of drilling."},
};

}  // namespace

PreparationMeasures::PreparationMeasures(const Preparation& preparation, const SessionTrack* track)
    : surfaces(preparation),
      form(cavityForm(preparation, surfaces)),
      extent(cavityExtent(preparation, surfaces)),
      undercut(tactooth::undercut(preparation, surfaces)),
      damage(tissueDamage(preparation, surfaces)),
      unsupportedEnamel(tactooth::unsupportedEnamel(preparation, surfaces)),
      margin(marginLine(preparation, surfaces)) {
    const ColumnGrid columns(preparation.axis, surfaces.cut.mesh, surfaces.idealCut.mesh, kSpacing);
    volumes = preparedVolumes(preparation, columns);
    deviation = surfaceDeviation(preparation, columns);
    tissues = tissueVolumes(preparation, volumes, kSpacing);
    hasSession = track != nullptr;
    if (hasSession) hand = handWork(*track);
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
