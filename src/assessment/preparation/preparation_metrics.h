// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "assessment/metric_table.h"
#include "assessment/preparation/cavity_extent.h"
#include "assessment/preparation/cavity_form.h"
#include "assessment/preparation/contact_gap.h"
#include "assessment/preparation/margin_line.h"
#include "assessment/preparation/occlusal_reduction.h"
#include "assessment/preparation/prepared_volumes.h"
#include "assessment/preparation/surface_deviation.h"
#include "assessment/preparation/tissue_damage.h"
#include "assessment/preparation/tissue_volumes.h"
#include "assessment/preparation/undercut.h"
#include "assessment/process/bur_coverage.h"
#include "assessment/process/hand_work.h"
#include "assessment/process/mirror_use.h"
#include "assessment/process/tissue_order.h"

namespace tactooth {

/// The finished sessions in which a preparation and its ideal were made; null: not known.
struct RecordedSessions {
    std::shared_ptr<const SessionTrack> student = {}, expert = {};
    Pose studentInTooth = {};  ///< of the student's tooth in the frame of the preparation
};

/// All that is measured on a finished preparation.
struct PreparationMeasures {
    /// Takes some seconds for a large tooth. The same on any number of threads.
    explicit PreparationMeasures(const Preparation& preparation, const RecordedSessions& sessions = {});

    CutSurfaces surfaces;
    PreparedVolumes volumes;
    SurfaceDeviation deviation;
    CavityForm form;
    CavityExtent extent;
    Undercut undercut;
    TissueDamage damage;
    ContactGap contact;
    Measured unsupportedEnamel;
    MarginLine margin;
    OcclusalReduction occlusal;
    Measured innerAngle;
    TissueVolumes tissues;
    Measured forbiddenVolume;
    bool hasSession = false;
    std::optional<HandWork> hand;  ///< nothing without a session, or if no tool has touched anything in it
    BurCoverage coverage;
    Measured mirrorTime;
    TissueOrder order;
    bool hasExpertSession = false;
    std::optional<HandWork> expertHand;  ///< the same of the expert's session
};

/// How a value is written for people.
enum class ValueForm {
    Measure,  ///< with the decimals of its unit
    Share,    ///< 0..1, written in %
    Count,    ///< without decimals
};

/// One metric of a finished preparation: a row of the table from which the command `assess`, its report, the criteria
/// of a rubric and the page docs/user/metrics.md are made. A new metric is a new row.
struct PreparationMetric {
    std::string_view id;     ///< in rubrics and JSON; stable
    std::string_view title;  ///< in reports
    std::string_view unit;   ///< "mm", "mm^2", "mm^3", "deg", "s", "N", "Hz" and so on; "1": a number without one
    Better better;
    Measured (*measure)(const PreparationMeasures& measures);
    std::string_view definition;  ///< for the documentation, with the source if it has one
    std::string_view titleJa, definitionJa;
    ValueForm form = ValueForm::Measure;

    [[nodiscard]] std::string_view titleIn(Language language) const {
        return language == Language::English ? title : titleJa;
    }
    [[nodiscard]] std::string_view definitionIn(Language language) const {
        return language == Language::English ? definition : definitionJa;
    }
};

/// In the order of the report.
[[nodiscard]] std::span<const PreparationMetric> preparationMetrics();
/// Null if there is no such metric.
[[nodiscard]] const PreparationMetric* findPreparationMetric(std::string_view id);

/// One value of the table, with its row.
struct MetricResult {
    const PreparationMetric* metric;
    Measured measured;
};
[[nodiscard]] std::vector<MetricResult> measureAll(const PreparationMeasures& measures);

}  // namespace tactooth
