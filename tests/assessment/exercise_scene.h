// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "assessment/exercise.h"
#include "assessment/preparation/preparation.h"

namespace tactooth::test {

/// An exercise with its tooth and its ideal shape; both are made once for each built-in exercise.
struct ExerciseScene {
    std::shared_ptr<const LayeredTooth> tooth;
    Expected<TriangleMesh> ideal = TriangleMesh{};
    std::shared_ptr<const SurfacePart> neighbours;  ///< uncut; null: the exercise has none

    [[nodiscard]] static const ExerciseScene& of(const Exercise& exercise);
    /// What the work is compared with: all but `prepared`. Needs the ideal.
    [[nodiscard]] Preparation preparation(const Exercise& exercise) const;
};

}  // namespace tactooth::test
