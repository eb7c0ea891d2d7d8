// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string_view>

#include "geometry/util/assert.h"
#include "instruments/anatomy/tooth_shape.h"

namespace tactooth {
namespace {

using ShapeFactory = ToothShape (*)();

constexpr std::array<ShapeFactory, 8> kUpper = {upperCentralIncisor, upperLateralIncisor, upperCanine,
                                                upperFirstPremolar,  upperSecondPremolar, upperFirstMolar,
                                                upperSecondMolar,    upperThirdMolar};
constexpr std::array<ShapeFactory, 8> kLower = {lowerCentralIncisor, lowerLateralIncisor, lowerCanine,
                                                lowerFirstPremolar,  lowerSecondPremolar, lowerFirstMolar,
                                                lowerSecondMolar,    lowerThirdMolar};

}  // namespace

ToothShape toothShape(int fdi) {
    const int quadrant = fdi / 10, place = fdi % 10;
    TACTOOTH_ASSERT(quadrant >= 1 && quadrant <= 4 && place >= 1 && place <= 8);
    ToothShape shape = (quadrant <= 2 ? kUpper : kLower)[static_cast<std::size_t>(place - 1)]();
    const bool leftSide = quadrant == 2 || quadrant == 3;
    constexpr std::string_view kRight = "right", kLeft = "left";
    if (leftSide) shape.name.replace(shape.name.find(kRight), kRight.size(), kLeft);
    shape.fdi = fdi;
    return shape;
}

}  // namespace tactooth
