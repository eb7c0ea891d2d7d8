// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "instruments/bur_catalogue.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {

/// One measurement of cutting: a bur is led into the top of a tooth, its whole head deep, and to and fro through it.
struct CutCase {
    BurSpec bur;
    double voxel = 0.025;   ///< mm
    double speed = 10;      ///< of the hand, mm/s
    double stroke = 5;      ///< length of a slide, mm
    int strokes = 2;        ///< slides, each 0.3 mm beside the last
    double removal = 1e3;   ///< times the materials' own: at 1000 the bur keeps up with the hand
    double engagement = 1;  ///< depth of the cut, in lengths of the bur's head
    int cores = 1;          ///< that the cutter may use
};

/// What it cost, in processor time; of a cutter that may use several cores, in time as it passes. Servo, cutter, lister
/// and the maker of bricks run as if each had cores of its own: an update is felt at the first tick that begins after
/// the time which it and its list took.
struct CutTiming {
    std::size_t ticks = 0;                ///< while the bur touched
    double p50 = 0, p99 = 0;              ///< of a tick, us
    double p999 = 0, largest = 0;         ///< of a tick, us
    double touchP50 = 0, touchP99 = 0;    ///< from a tick in which the bur works to the tick that feels what it cut, ms
    double carvedP50 = 0, carvedP99 = 0;  ///< from the beginning of a carve to the tick that feels it, ms
    std::size_t updates = 0;              ///< new surfaces
    double updateP50 = 0;                 ///< carve and new surface, ms
    double updateP99 = 0;                 ///< the same
    double updateLargest = 0;             ///< the same
    std::size_t lists = 0;                ///< made ahead for the servo, with a new surface or without
    double listP50 = 0;                   ///< of one, ms
    double updatesPerSecond = 0;          ///< while the bur works
    double prefetchShare = 0;             ///< of a core: what it takes to make bricks ahead of the bur
    double firstUpdate = 0;               ///< from a tooth without any brick to its first cut surface, ms
    double removed = 0;                   ///< mm^3
    double nanosPerVoxel = 0;             ///< cutter's time for each voxel of removed volume
    double brickMegabytes = 0;            ///< of the cut volume at the end
    double residentMegabytes = 0;         ///< of the whole process at the end
    double deepest = 0;                   ///< how far the hand was ahead of the bur at most, mm
};

[[nodiscard]] CutTiming timeCutting(const std::shared_ptr<const LayeredTooth>& tooth, const CutCase& cut);

/// A round bur of any size, as the catalogue's are.
[[nodiscard]] BurSpec roundBur(double diameter);

}  // namespace tactooth
