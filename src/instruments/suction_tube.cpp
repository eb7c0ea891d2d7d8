// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/suction_tube.h"

#include <vector>

#include "instruments/modelling/surface_of_revolution.h"

namespace tactooth {

TriangleMesh makeSuctionTube() {
    // From the floor of the bore, which is as deep as the eye can see, around the rounded lip to the far end.
    const std::vector<OutlinePoint> outline = {{0, 14},    {2.2, 14}, {2.2, 0.5}, {2.3, 0.15}, {2.6, 0},  {2.85, 0.15},
                                               {3.0, 0.5}, {3.0, 60}, {3.3, 62},  {3.3, 88},   {3.0, 90}, {0, 90}};
    constexpr int kSides = 48;
    return revolved(outline, kSides);
}

}  // namespace tactooth
