// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/anatomy/cusp_variation.h"

#include <algorithm>
#include <cmath>

#include "instruments/anatomy/deviation.h"
#include "instruments/anatomy/occlusal_table.h"

namespace tactooth {
namespace {

// How often an extra cusp occurs or one is missing is chosen: reports differ much between peoples, and these shares are
// near to those of Europeans.

// The grooves that part a cusp from its neighbours: mm from its tip to their middles, and to a furrow of the side.
constexpr double kPartingGrooves = 2.25, kPartingFurrow = 1.3;
constexpr double kFaintest = 0.08, kDeepest = 1.3;  // shares of the depth that these grooves keep or gain

/// Makes a cusp larger (size above 1) or smaller; at 0 it is merged into its neighbours. `height`: mm that its tip
/// loses from size 1 to 0.
void resizeCusp(PosteriorToothPlan& plan, std::size_t index, double size, double height) {
    Cusp& cusp = plan.cusps[index];
    raiseLandmarks(plan, cusp.x, cusp.y, (size - 1) * height);
    cusp.z += (size - 1) * height;
    const double depth = std::clamp(size, kFaintest, kDeepest);
    for (OcclusalGroove& g : plan.grooves) {
        if (std::hypot((g.ax + g.bx) / 2 - cusp.x, (g.ay + g.by) / 2 - cusp.y) > kPartingGrooves) continue;
        g.depth *= depth;
        g.endDepth *= depth;
    }
    for (DevelopmentalGroove& g : plan.developmentalGrooves) {
        if (g.buccal == (cusp.y > 0) && std::abs(g.x - cusp.x) < kPartingFurrow) g.depth *= depth;
    }
}

/// The distal cusp of a lower first molar. One of ten has four cusps.
void varyDistalCusp(PosteriorToothPlan& plan, std::mt19937& random) {
    constexpr std::size_t kDistal = 2;                            // its place in the plan
    constexpr double kAbsent = 0.1;                               // share of the people
    constexpr double kSmall = 0.6, kLarge = 1.35, kHeight = 0.6;  // sizes and mm, chosen
    const bool absent = numberBetween(random, 0, 1) < kAbsent;
    const double size = numberBetween(random, kSmall, kLarge);
    resizeCusp(plan, kDistal, absent ? 0 : size, kHeight);
}

/// A fifth cusp of a lower second molar, which one of six has: low, on the distal end of the buccal row, with a groove
/// from the distal pit to the cheek.
void varyFifthCusp(PosteriorToothPlan& plan, std::mt19937& random) {
    constexpr double kPresent = 1.0 / 6;               // share of the people
    constexpr double kLowest = 5.75, kHighest = 6.15;  // mm, height of its tip, chosen: below the distobuccal cusp
    const bool present = numberBetween(random, 0, 1) < kPresent;
    const double tip = numberBetween(random, kLowest, kHighest);
    if (!present) return;
    constexpr double kX = -3.75, kY = 1.45;  // mm, chosen: distal of the distobuccal cusp, nearer the middle
    plan.cusps.push_back({kX, kY, tip, 0.86, -0.51, 0.45, 0.75, 0.50});
    plan.landmarks.push_back({kX, kY, plan.top - tip});
    plan.landmarks.push_back({-3.25, 2.30, plan.top - tip + 0.45});
    plan.grooves.push_back({-2.40, 0.25, -2.95, 1.30, 0.22, 0.34, 0.24});
    plan.grooves.push_back({-2.95, 1.30, -3.25, 2.30, 0.24, 0.36, 0.24});
    plan.grooves.push_back({-3.25, 2.30, -3.65, 3.70, 0.24, 0.38, 0.20});
    plan.developmentalGrooves.push_back({true, -3.45, 0.16, 0.50});
}

/// The distolingual cusp of an upper first molar, the most variable of its four.
void varyDistolingualCusp(PosteriorToothPlan& plan, std::mt19937& random) {
    constexpr std::size_t kDistolingual = 3;
    // Sizes chosen for the tables' 0.8 to 1.65 mm below the highest cusp.
    constexpr double kSmall = 0.5, kLarge = 1.2, kHeight = 1.0;
    resizeCusp(plan, kDistolingual, numberBetween(random, kSmall, kLarge), kHeight);
}

/// That of an upper second molar: from none, with a heart-shaped outline, to a cusp with a tip of its own. Both forms
/// are common.
void varySecondMolar(PosteriorToothPlan& plan, std::mt19937& random) {
    constexpr std::size_t kDistolingual = 3, kHeartWave = 3;
    constexpr double kLarge = 2.4, kHeight = 0.5;  // the average plan has a low shoulder: size 1
    const double size = numberBetween(random, 0, kLarge);
    resizeCusp(plan, kDistolingual, size, kHeight);
    constexpr double kStraighter = 0.35;  // share of the wave that a larger cusp takes away for each size, chosen
    plan.outline[kHeartWave].sine *= 1 - kStraighter * (size - 1);
}

/// The tubercle of Carabelli: none, a groove, or a cusp with a groove above it. It stands below the tip of the
/// mesiolingual cusp, at a third to half of the crown's height.
void varyTubercle(PosteriorToothPlan& plan, std::mt19937& random) {
    constexpr double kPresent = 0.6;                           // share of the people
    constexpr double kOnlyGroove = 0.3;                        // share of the grades, chosen
    constexpr double kLargest = 0.85;                          // mm that it stands out, chosen
    constexpr double kFaintGroove = 0.10, kDeepGroove = 0.24;  // mm, chosen
    const double grade = 1 - numberBetween(random, 0, 1) / kPresent;
    const double x = numberBetween(random, 0.9, 1.6), z = numberBetween(random, 3.0, 3.7);  // mm, chosen
    if (grade <= 0) return;
    plan.tubercle = {.x = x,
                     .z = z,
                     .height = kLargest * std::max(0.0, (grade - kOnlyGroove) / (1 - kOnlyGroove)),
                     .width = 1.25,
                     .groove = std::lerp(kFaintGroove, kDeepGroove, grade)};
}

}  // namespace

void varyCuspNumber(PosteriorToothPlan& plan, std::mt19937& random) {
    switch (plan.fdi) {
        case 46:
            return varyDistalCusp(plan, random);
        case 47:
            return varyFifthCusp(plan, random);
        case 16:
            varyDistolingualCusp(plan, random);
            return varyTubercle(plan, random);
        case 17:
            return varySecondMolar(plan, random);
        default:
            return;
    }
}

}  // namespace tactooth
