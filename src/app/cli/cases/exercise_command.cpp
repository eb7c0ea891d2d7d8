// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/exercise_command.h"

#include <fmt/core.h>

#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "assessment/allowed_instruments.h"
#include "assessment/cavity_metrics.h"
#include "assessment/exercise_file.h"
#include "assessment/rubric/exercise_rubric.h"
#include "assessment/rubric/rubric_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/io/stl_writer.h"
#include "geometry/util/display_text.h"
#include "geometry/util/number_text.h"
#include "instruments/bur_catalogue.h"
#include "session/cases/custom_bur.h"

namespace tactooth {
namespace {

std::string toothOf(const Exercise& exercise) {
    const auto* request = std::get_if<ToothRequest>(&exercise.tooth);
    if (request == nullptr) return displayName(std::get<ToothSource>(exercise.tooth).outer);
    return fmt::format("{}, {}", request->fdi, toothName(request->fdi));
}

Expected<std::string> burOf(const Exercise& exercise) {
    const auto* number = std::get_if<std::string>(&exercise.bur);
    if (number != nullptr) return findBur(*number)->name;
    const Expected<CustomBur> own = readCustomBur(std::get<std::filesystem::path>(exercise.bur));
    if (!own) return Unexpected{own.error()};
    return own->name;
}

/// How the exercise names it, and its title.
Expected<std::string> rubricIn(const Exercise& exercise) {
    const Expected<Rubric> rubric = rubricOf(exercise);
    if (!rubric) return Unexpected{rubric.error()};
    const std::string name = exercise.rubric.empty() ? std::string(kUsualRubric) : exercise.rubric;
    return fmt::format("{} ({})", displayName(name), displayText(rubric->name));
}

Expected<void> describe(const ExerciseOptions& options) {
    FileTransaction files;
    if (builtinExercise(options.exercise) == nullptr) files.reads(options.exercise);
    if (auto opened = files.open(options.out); !opened) return opened;
    const Expected<Exercise> exercise = findExercise(options.exercise);
    if (!exercise) return Unexpected{exercise.error()};
    const Expected<std::string> bur = burOf(*exercise);
    if (!bur) return Unexpected{bur.error()};
    const auto tooth = exerciseTooth(*exercise);
    if (!tooth) return Unexpected{tooth.error()};
    Expected<TriangleMesh> ideal = idealShape(*exercise, *tooth);
    if (!ideal) return Unexpected{ideal.error()};
    const Expected<std::string> rubric = rubricIn(*exercise);
    if (!rubric) return Unexpected{rubric.error()};
    if (!options.out.empty()) {
        if (auto written = writeStl(*ideal, options.out); !written) return written;
    }
    const auto surface = std::make_shared<const SurfacePart>(std::move(*ideal));
    const auto outer = (*tooth)->ownOuter();
    const CavityWalls walls = cavityWalls(surface->mesh(), *outer);
    CavityMetrics metrics(surface, *outer, walls);
    if (metrics.empty()) {
        return unexpected(msg::kIdealLeavesNothing, quotedWord(options.exercise));
    }
    if (auto named = files.commit(); !named) return named;
    Surface whole;
    whole.base = outer;
    print("{}\n{}\n", exercise->name, exercise->task);
    if (!exercise->brief.empty()) print("{}\n", exercise->brief);
    print("  group           {}, {}\n", titleOf(exercise->group).english, titleOf(exercise->level).english);
    print("  tooth           {}\n  bur             {}\n", toothOf(*exercise), *bur);
    for (const std::string& other : exercise->otherBurs) print("  or              {}\n", findBur(other)->name);
    if (exercise->onlyTheseBurs) print("  burs            these only\n");
    if (!exercise->instruments.empty()) print("  instruments     {}\n", instrumentNames(*exercise));
    if (exercise->minutes) print("  time            {} min\n", *exercise->minutes);
    print("  rubric          {}\n", *rubric);
    print("  ideal cavity    {:.2f} mm3\n", metrics.of(whole, 0).planned);
    if (const auto left = leastToPulp(walls, **tooth)) {
        if (*left > 0) print("  to the pulp     {:.2f} mm at least\n", *left);
        if (*left <= 0) print("  to the pulp     nothing: the cavity opens it\n");
    }
    if (!options.out.empty()) print("  ideal shape     {}\n", displayName(options.out));
    return {};
}

}  // namespace

int runExercise(const ExerciseOptions& options) {
    const auto done = describe(options);
    return done ? kExitOk : reportError(done.error());
}

}  // namespace tactooth
