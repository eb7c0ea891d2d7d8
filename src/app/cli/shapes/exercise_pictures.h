// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/exercise.h"
#include "view/render/offscreen.h"

namespace tactooth {

/// Draws the ideal of an exercise: the tooth as it should be in the end, with the teeth and gums beside it, seen as the
/// exercise begins. Takes some seconds, for a crown half a minute. Fails with one sentence.
[[nodiscard]] Expected<Image> exercisePicture(OffscreenRenderer& renderer,
                                              const std::shared_ptr<const Exercise>& exercise, ImageSize size);

}  // namespace tactooth
