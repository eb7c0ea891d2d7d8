// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/exercise_clock.h"

#include <algorithm>

namespace tactooth {

double ExerciseClock::seconds(double worked) const {
    return stoppedAt_ ? *stoppedAt_ : std::max(0.0, worked - notCounted_);
}

void ExerciseClock::stop(double worked) { stoppedAt_ = seconds(worked); }

void ExerciseClock::goOn(double worked) {
    if (!stoppedAt_) return;
    notCounted_ = std::max(0.0, worked - *stoppedAt_);
    stoppedAt_.reset();
}

void ExerciseClock::restart() { *this = {}; }

}  // namespace tactooth
