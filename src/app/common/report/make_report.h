// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "assessment/exercise.h"
#include "assessment/preparation/preparation.h"
#include "assessment/preparation/scan_alignment.h"
#include "assessment/report/assessment_report.h"
#include "session/track/session_track.h"

namespace tactooth {

/// A work that is assessed, and what it is compared with.
struct AssessedWork {
    Preparation preparation;
    std::string student, expert;                         ///< for people: the work, and what it is compared with
    std::string task = {};                               ///< of the exercise; empty: there is none
    std::string japaneseExpert = {}, japaneseTask = {};  ///< empty: the same as these
    std::string name = {};                               ///< of the student; empty: not known
    std::string date = {};                               ///< of the work; empty: not known
    std::string comment = {};                            ///< of the teacher; empty: there is none
    double tolerance = 0.3;           ///< mm: of the exercise, else as teachers allow (docs/assessment.md)
    std::optional<ScanFit> fit = {};  ///< of a surface from a file
    std::shared_ptr<const SessionTrack> track = {};        ///< the finished session; null: not known
    Pose sessionInTooth = {};                              ///< of its tooth in the frame of the preparation
    std::shared_ptr<const SessionTrack> expertTrack = {};  ///< that of the expert; null: not known
    /// Receives the share of the assessment that is done, 0..1; empty: nobody wants to know.
    std::function<void(double)> progress = {};
};

/// Version and commit of this program.
[[nodiscard]] std::string programText();

/// Names the exercise whose ideal the work is compared with, and takes its tolerance and its forbidden zones.
void setExercise(AssessedWork& work, const Exercise& exercise);

/// Measures and marks a work, and draws its pictures. Takes some seconds. `rubric` outlives the report. Fails with one
/// sentence if there is nothing to compare with or to judge, or no font for the language. Without OpenGL the report has
/// no pictures. `language`: of its pages.
[[nodiscard]] Expected<AssessmentReport> makeReport(const AssessedWork& work, const Rubric& rubric,
                                                    Language language = Language::English);

/// The names of the files of a report.
inline constexpr std::array kReportFiles = {"report.html", "report.pdf", "report.json", "report.csv"};

/// Writes the four files into a folder that exists.
[[nodiscard]] Expected<void> writeReport(const std::filesystem::path& folder, const AssessmentReport& report);

}  // namespace tactooth
