// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "assessment/exercise.h"
#include "assessment/rubric/rubric.h"

namespace tactooth {

/// The rubric that marks an exercise: `other` (a built-in one, or a file) unless that is empty, else the exercise's
/// own, else the usual one. For an exercise with forbidden zones it has a criterion more: a cut there is a critical
/// error. Fails with one sentence.
[[nodiscard]] Expected<Rubric> rubricOf(const Exercise& exercise, const std::string& other = {});

}  // namespace tactooth
