// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/chair_view.h"

#include <array>
#include <numbers>

#include "geometry/util/assert.h"
#include "geometry/util/degree.h"
#include "instruments/builtin_tooth.h"

namespace tactooth {
namespace {

/// One row for each part of the mouth.
struct Row {
    int clock;
    bool mirror;
    double towardMesial;  ///< degrees from buccal
    double elevation;     ///< degrees above the view from the side
};

// Positions from 9 to 12 o'clock, the line of sight as square on the surface as it can be, and the mirror for surfaces
// that no direct line reaches: A. Qualtrough, J. Satterthwaite, L. Morrow, P. Brunton, Principles of operative
// dentistry, 2005, chapter 1. The upper chewing surfaces look away from the dentist's eye: the mirror shows them, held
// below them and square on. On the lower left the patient's head is turned toward the dentist. The angles are ours:
// those of a lower molar leave room for the handpiece.
constexpr Row kUpperRight{11, true, 10, 62}, kUpperFront{12, false, 0, 30}, kUpperLeft{12, true, 10, 62};
constexpr Row kLowerRight{9, false, 18.4, 35.5}, kLowerFront{12, false, 0, 45}, kLowerLeft{11, false, 18.4, 35.5};

const Row& rowOf(int fdi) {
    const bool front = isAnteriorTooth(fdi);
    switch (fdi / 10) {
        case 1:
            return front ? kUpperFront : kUpperRight;
        case 2:
            return front ? kUpperFront : kUpperLeft;
        case 3:
            return front ? kLowerFront : kLowerLeft;
        default:
            return front ? kLowerFront : kLowerRight;
    }
}

}  // namespace

ChairView chairView(int fdi) {
    TACTOOTH_ASSERT(isPermanentTooth(fdi));
    const Row& row = rowOf(fdi);
    const double fromBuccal = mesialX(fdi) * row.towardMesial * kDegree;
    return {row.clock, row.mirror, {std::numbers::pi / 2 - fromBuccal, row.elevation * kDegree}};
}

}  // namespace tactooth
