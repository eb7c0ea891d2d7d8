// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "instruments/bur_catalogue.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {

/// What a still tool does in the slot that a bur has just cut.
enum class SlotMotion {
    Rest,    ///< is pressed into the slot's floor
    Tremor,  ///< the same with a tremor of 20 um at 9 Hz across the slot
    Slide,   ///< goes to and fro along the slot at 5 mm/s
    Turn     ///< turns about its shaft to and fro, 5 degrees at 30 degrees a second
};
inline constexpr std::array kSlotMotions = {SlotMotion::Rest, SlotMotion::Tremor, SlotMotion::Slide, SlotMotion::Turn};
/// "rests", "trembles", "slides", "turns".
[[nodiscard]] std::string_view slotMotionName(SlotMotion motion);

/// How a tool fares that touches its slot on all sides.
struct SlotTiming {
    SlotMotion motion;
    std::size_t ticks = 0;
    double p50 = 0, p99 = 0;       ///< of a tick, us of processor time
    double p999 = 0, largest = 0;  ///< the same
    double force = 0;              ///< mean, N
    double noise = 0;              ///< largest difference of a tick's force from the mean, N; says something at rest
    double sunk = 0;               ///< how far the tool has gone along its shaft meanwhile, mm
    bool leaves = false;           ///< a hand that draws back takes the tool out of the slot, without force at the end
};

/// Lets `bur` cut a slot across the top of the tooth, `depth` mm deep, and then has each motion made in it with the
/// spindle still: by the bur itself, or by a periodontal probe.
[[nodiscard]] std::vector<SlotTiming> timeInSlot(const std::shared_ptr<const LayeredTooth>& tooth, const BurSpec& bur,
                                                 double depth, double voxel, bool probe);

}  // namespace tactooth
