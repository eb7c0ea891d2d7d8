// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this folder: what it says to people, in both languages.
namespace tactooth::msg {

// Names of teeth: quadrant and kind.
inline constexpr MessageText kToothTitle{"tooth_title", "%1 %2", "%1%2"};
inline constexpr MessageText kUpperRight{"upper_right", "Upper right", "上顎右側"};
inline constexpr MessageText kUpperLeft{"upper_left", "Upper left", "上顎左側"};
inline constexpr MessageText kLowerLeft{"lower_left", "Lower left", "下顎左側"};
inline constexpr MessageText kLowerRight{"lower_right", "Lower right", "下顎右側"};
inline constexpr MessageText kCentralIncisor{"central_incisor", "central incisor", "中切歯"};
inline constexpr MessageText kLateralIncisor{"lateral_incisor", "lateral incisor", "側切歯"};
inline constexpr MessageText kCanine{"canine", "canine", "犬歯"};
inline constexpr MessageText kFirstPremolar{"first_premolar", "first premolar", "第一小臼歯"};
inline constexpr MessageText kSecondPremolar{"second_premolar", "second premolar", "第二小臼歯"};
inline constexpr MessageText kFirstMolar{"first_molar", "first molar", "第一大臼歯"};
inline constexpr MessageText kSecondMolar{"second_molar", "second molar", "第二大臼歯"};
inline constexpr MessageText kThirdMolar{"third_molar", "third molar", "第三大臼歯"};

}  // namespace tactooth::msg
