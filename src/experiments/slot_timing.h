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

/// The motion of a tool at rest in the slot that a bur has just cut.
enum class SlotMotion {
    Rest,    ///< pressed into the slot's floor
    Tremor,  ///< the same with a tremor of 20 um at 9 Hz across the slot
    Slide,   ///< to and fro along the slot at 5 mm/s
    Turn     ///< rotation about the shaft, to and fro by 5 degrees at 30 degrees/s
};
inline constexpr std::array kSlotMotions = {SlotMotion::Rest, SlotMotion::Tremor, SlotMotion::Slide, SlotMotion::Turn};
/// "rests", "trembles", "slides", "turns".
[[nodiscard]] std::string_view slotMotionName(SlotMotion motion);

/// The results for a tool that touches its slot on all sides.
struct SlotTiming {
    SlotMotion motion;
    std::size_t ticks = 0;
    double p50 = 0, p99 = 0;       ///< of a tick, us of processor time
    double p999 = 0, largest = 0;  ///< the same
    double force = 0;              ///< mean, N
    double noise = 0;              ///< greatest difference of a tick's force from the mean, N; meaningful at rest
    double sunk = 0;               ///< motion of the tool along its shaft meanwhile, mm
    bool leaves = false;  ///< whether the tool leaves the slot when the hand draws back, with no force at the end
};

/// Cuts a slot across the top of the tooth with `bur`, `depth` mm deep. Then it makes each motion in the slot with the
/// spindle at rest: with the bur itself, or with a periodontal probe.
[[nodiscard]] std::vector<SlotTiming> timeInSlot(const std::shared_ptr<const LayeredTooth>& tooth, const BurSpec& bur,
                                                 double depth, double voxel, bool probe);

}  // namespace tactooth
