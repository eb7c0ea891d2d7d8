// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "geometry/util/expected.h"
#include "instruments/spindle.h"
#include "sound/output/offline_render.h"

namespace tactooth {

/// Reads what a bur does over time, to be heard: a CSV file with the columns t,speed_rpm,power,material (s, rev/min,
/// removal power in W, a material's name or "none"). Times count from the first row on. Between two rows speed and
/// power go in a straight line; two rows at one time are a step. While the material is "none" nothing is cut; the row
/// that names one again is a landing, at the speed of a careful hand.
///
/// The load is the torque that the power takes at that speed from `drive`, and the pedal is where the drive would reach
/// the speed with that load: a bur at rest without a load has no air.
///
/// Fails with one sentence with file and line on everything that readCsv refuses, a speed or power that is negative or
/// higher than any drive's, an unknown material, a time before the one of the row above; and if the rows span
/// no time or more than kMaxSoundLength.
[[nodiscard]] Expected<std::vector<TimedSoundState>> readSoundProfile(const std::filesystem::path& path,
                                                                      const SpindlePreset& drive);

/// The same from memory; `name` stands for the file in messages.
[[nodiscard]] Expected<std::vector<TimedSoundState>> parseSoundProfile(std::string_view text, std::string_view name,
                                                                       const SpindlePreset& drive);

}  // namespace tactooth
