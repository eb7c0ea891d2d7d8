// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "instruments/bur_catalogue.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {

/// One measurement of cutting: a bur goes into the top of a tooth by the length of its head, and to and fro through it.
struct CutCase {
    BurSpec bur;
    double voxel = 0.025;   ///< mm
    double speed = 10;      ///< of the hand, mm/s
    double stroke = 5;      ///< length of a slide, mm
    int strokes = 2;        ///< slides, each 0.3 mm beside the last
    double removal = 1e3;   ///< factor on the materials' removal; at 1000 the bur keeps up with the hand
    double engagement = 1;  ///< depth of the cut, in lengths of the bur's head
    int cores = 1;          ///< for the carving thread
};

/// The cost in processor time, or in wall time for a carving thread with several cores. The servo, carving,
/// neighbour-list and brick-prefetch threads are simulated as if each had cores of its own: the servo uses an
/// update at the first tick after the time that it and its list took.
struct CutTiming {
    std::size_t ticks = 0;                ///< while the bur touched
    double p50 = 0, p99 = 0;              ///< of a tick, us
    double p999 = 0, largest = 0;         ///< of a tick, us
    double touchP50 = 0, touchP99 = 0;    ///< from a tick in which the bur cuts to the tick that feels the cut, ms
    double carvedP50 = 0, carvedP99 = 0;  ///< from the start of a carve to the tick that feels it, ms
    std::size_t updates = 0;              ///< new surfaces
    double updateP50 = 0;                 ///< carve and new surface, ms
    double updateP99 = 0;                 ///< the same
    double updateLargest = 0;             ///< the same
    std::size_t lists = 0;                ///< neighbour lists, with a new surface or without
    double listP50 = 0;                   ///< of one, ms
    double updatesPerSecond = 0;          ///< while the bur cuts
    double prefetchShare = 0;             ///< share of a core for the brick prefetch
    double firstUpdate = 0;               ///< from a tooth without bricks to its first cut surface, ms
    double removed = 0;                   ///< mm^3
    double nanosPerVoxel = 0;             ///< carving time for each voxel of removed volume
    double brickMegabytes = 0;            ///< of the cut volume at the end
    double residentMegabytes = 0;         ///< of the whole process at the end
    double deepest = 0;                   ///< greatest distance of the device ahead of the bur, mm
};

[[nodiscard]] CutTiming timeCutting(const std::shared_ptr<const LayeredTooth>& tooth, const CutCase& cut);

/// A round bur of any diameter, with the proportions of the catalogue.
[[nodiscard]] BurSpec roundBur(double diameter);

}  // namespace tactooth
