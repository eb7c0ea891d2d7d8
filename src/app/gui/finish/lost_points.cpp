// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/finish/lost_points.h"

#include <algorithm>

namespace tactooth {

std::vector<LostPoint> lostPoints(const Mark& mark) {
    std::vector<LostPoint> points;
    for (const CriterionScore& score : mark.criteria) {
        const bool limits = std::ranges::find(mark.limitedBy, score.criterion) != mark.limitedBy.end();
        points.push_back({&score, limits});
    }
    std::ranges::stable_sort(points, [](const LostPoint& a, const LostPoint& b) {
        if (a.limitsMark != b.limitsMark) return a.limitsMark;
        return a.score->lost > b.score->lost;
    });
    return points;
}

double replayStart(double moment) {
    constexpr double kBefore = 2;  // s: enough to see how the hand comes there
    return std::max(0.0, moment - kBefore);
}

ErrorReplay errorReplay(const LostPoint& point, bool hasRecording) {
    if (!hasRecording) return ErrorReplay::NoRecording;
    return point.score->measured.moment ? ErrorReplay::Possible : ErrorReplay::NoMoment;
}

}  // namespace tactooth
