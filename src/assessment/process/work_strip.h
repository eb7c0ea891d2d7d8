// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "collision/bvh/surface.h"
#include "geometry/util/message.h"
#include "session/track/session_track.h"

namespace tactooth {

/// Force and depth over the time of a session, for a drawing (report/strip_svg.h).
struct WorkStrip {
    struct Column {
        double force = 0;  ///< the greatest on the hand while the tool touches, N
        double depth = 0;  ///< the greatest of the bur's tip below the uncut surface, mm
    };
    struct Mark {
        double time;  ///< s
        std::string text;
        bool isError = false;
    };
    double seconds = 0;  ///< the columns divide this time equally
    std::vector<Column> columns = {};
    std::vector<Mark> marks = {};  ///< in the order of their times
};

/// `columns`: number of them, at least 1. The marks are the first of each kind of event of the track, `mostMarks` of
/// them at most.
[[nodiscard]] WorkStrip workStrip(const SessionTrack& track, const SurfacePart& original, std::size_t columns,
                                  std::size_t mostMarks, Language language = Language::English);

}  // namespace tactooth
