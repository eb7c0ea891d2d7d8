// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/editor/exercise_draft.h"
#include "app/gui/scene/outline_overlay.h"

namespace tactooth {

/// A point of a draft's line.
struct DraftPoint {
    DraftLine line;
    std::size_t point = 0;

    bool operator==(const DraftPoint&) const = default;
};

/// What a draft draws on its tooth: first its lines, in their order. `outer`: of the tooth; `held`: the point that the
/// mouse is on.
[[nodiscard]] OutlineMarks marksOf(const ExerciseDraft& draft, const std::shared_ptr<const SurfacePart>& outer,
                                   const std::optional<DraftPoint>& held);

}  // namespace tactooth
