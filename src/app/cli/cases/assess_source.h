// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/cases/assess_command.h"
#include "app/cli/cases/given_tooth.h"
#include "app/common/report/make_report.h"
#include "assessment/exercise.h"
#include "geometry/files/file_transaction.h"

namespace tactooth {

/// Names the files that the options read, so that no output replaces one of them.
void addInputs(FileTransaction& files, const ComparisonOptions& options);

/// What works are compared with, read once for all of them: the exercise or the expert's tooth, the uncut tooth and the
/// rubric.
class AssessSource {
public:
    /// Reads all that the options name. Fails with one sentence.
    [[nodiscard]] static Expected<AssessSource> load(const ComparisonOptions& options);

    /// Reads a student's work and places it beside the ideal one, in one frame. Fails with one sentence.
    [[nodiscard]] Expected<AssessedWork> workOf(const std::filesystem::path& file,
                                                std::vector<ImportNote>& notes) const;
    /// That of the options, else that of the exercise, else the usual one.
    [[nodiscard]] const Rubric& rubric() const { return rubric_; }
    [[nodiscard]] const std::vector<ImportNote>& importNotes() const { return notes_; }

private:
    AssessSource() = default;

    Rubric rubric_;
    std::optional<Exercise> exercise_;
    std::optional<GivenTooth> expert_;                      // one of the two
    std::shared_ptr<const SurfacePart> ideal_;              // of the exercise
    std::vector<std::shared_ptr<const SurfacePart>> gums_;  // of the exercise
    std::shared_ptr<const LayeredTooth> uncut_;             // null: that of each work
    std::shared_ptr<const SurfacePart> original_;           // its surface
    std::string originalName_;                              // empty: it comes with the work
    bool align_ = false;
    std::vector<ImportNote> notes_;
};

}  // namespace tactooth
