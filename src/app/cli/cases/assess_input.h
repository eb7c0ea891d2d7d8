// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/cases/assess_command.h"
#include "assessment/preparation/preparation.h"
#include "assessment/preparation/scan_alignment.h"
#include "geometry/io/import_note.h"
#include "session/track/session_track.h"

namespace tactooth {

/// What is assessed, in one frame.
struct AssessInput {
    Preparation preparation;
    std::string student, expert;      ///< for people
    std::string task = {};            ///< of the exercise
    double tolerance = 0.3;           ///< mm: of the exercise, else as teachers allow (docs/assessment.md)
    std::optional<ScanFit> fit = {};  ///< of a student's surface from a file
    std::shared_ptr<const SessionTrack> track = {};  ///< of a student's recording; null: there is none
    std::vector<ImportNote> importNotes = {};
};

/// Reads and places all that the options name. Fails with one sentence.
[[nodiscard]] Expected<AssessInput> loadAssessInput(const AssessOptions& options);

}  // namespace tactooth
