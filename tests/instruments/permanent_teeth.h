// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Wheeler's average teeth, and the properties of the layers of every built-in tooth.
#pragma once

#include <array>

#include "instruments/builtin_tooth.h"

namespace tactooth::test {

/// Lengths in mm; `fdi` of the right side.
struct AverageTooth {
    int fdi;
    double crown, root, mesiodistal, faciolingual, cervixMesiodistal, cervixFaciolingual, mesialRise, distalRise;
};

inline constexpr std::array<AverageTooth, 16> kAverageTeeth = {{{11, 10.5, 13.0, 8.5, 7.0, 7.0, 6.0, 3.5, 2.5},
                                                                {12, 9.0, 13.0, 6.5, 6.0, 5.0, 5.0, 3.0, 2.0},
                                                                {13, 10.0, 17.0, 7.5, 8.0, 5.5, 7.0, 2.5, 1.5},
                                                                {14, 8.5, 14.0, 7.0, 9.0, 5.0, 8.0, 1.0, 0.0},
                                                                {15, 8.5, 14.0, 7.0, 9.0, 5.0, 8.0, 1.0, 0.0},
                                                                {16, 7.5, 13.0, 10.0, 11.0, 8.0, 10.0, 1.0, 0.0},
                                                                {17, 7.0, 12.0, 9.0, 11.0, 7.0, 10.0, 1.0, 0.0},
                                                                {18, 6.5, 11.0, 8.5, 10.0, 6.5, 9.5, 1.0, 0.0},
                                                                {41, 9.0, 12.5, 5.0, 6.0, 3.5, 5.3, 3.0, 2.0},
                                                                {42, 9.5, 14.0, 5.5, 6.5, 4.0, 5.8, 3.0, 2.0},
                                                                {43, 11.0, 16.0, 7.0, 7.5, 5.5, 7.0, 2.5, 1.0},
                                                                {44, 8.5, 14.0, 7.0, 7.5, 5.0, 6.5, 1.0, 0.0},
                                                                {45, 8.0, 14.5, 7.0, 8.0, 5.0, 7.0, 1.0, 0.0},
                                                                {46, 7.5, 14.0, 11.0, 10.5, 9.0, 9.0, 1.0, 0.0},
                                                                {47, 7.0, 13.0, 10.5, 10.0, 8.0, 9.0, 1.0, 0.0},
                                                                {48, 7.0, 11.0, 10.0, 9.5, 7.5, 9.0, 1.0, 0.0}}};

/// Every layer is closed, faces outward, is one component and does not intersect itself.
void expectValidLayers(const BuiltinTooth& tooth);

/// The pulp stays at least 0.05 mm within the dentin, and the dentin of the crown within the enamel.
void expectNestedLayers(const BuiltinTooth& tooth);

}  // namespace tactooth::test
