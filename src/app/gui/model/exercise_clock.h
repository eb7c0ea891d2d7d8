// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace tactooth {

/// The time of an exercise. It stands still from *Finish* until the student goes on; what passes meanwhile does not
/// count. `worked`: what the session has counted, s (TickLog::workSeconds).
class ExerciseClock {
public:
    [[nodiscard]] double seconds(double worked) const;
    void stop(double worked);
    void goOn(double worked);
    /// Another tooth, or the same one from the start.
    void restart();
    [[nodiscard]] bool isStopped() const { return stoppedAt_.has_value(); }

private:
    std::optional<double> stoppedAt_;  // s of this clock
    double notCounted_ = 0;            // s
};

}  // namespace tactooth
