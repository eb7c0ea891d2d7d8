// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "assessment/rubric/rubric.h"

namespace tactooth {

/// A line of the list of what a mark is made of.
struct LostPoint {
    const CriterionScore* score;  ///< never null
    bool limitsMark;              ///< the mark is no better because of it
};

/// All criteria of a mark, which outlives the list: first what limits it, then the dearest. What costs nothing keeps
/// the order of the rubric.
[[nodiscard]] std::vector<LostPoint> lostPoints(const Mark& mark);

/// Where a replay begins that shows what happened at `moment`, s: a little before it.
[[nodiscard]] double replayStart(double moment);

/// Whether the moment of an error can be replayed.
enum class ErrorReplay { Possible, NoRecording, NoMoment };
[[nodiscard]] ErrorReplay errorReplay(const LostPoint& point, bool hasRecording);

}  // namespace tactooth
