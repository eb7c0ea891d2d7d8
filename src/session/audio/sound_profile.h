// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "geometry/util/expected.h"
#include "instruments/spindle.h"
#include "sound/output/offline_render.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

/// Reads the course of a cut, to be heard: a CSV file with the columns t,speed_rpm,power,material (s, rev/min, removal
/// power in W, the name of one of `materials` or "none"). Time starts at the first row. Speed and power are linear
/// between two rows; two rows at one time are a step. While the material is "none" nothing is cut. The next row with a
/// material is a contact onset, at the speed of a careful hand.
///
/// The load is the torque of the power at that speed. The pedal is the position at which `drive` reaches the speed with
/// that load: a bur at rest without a load gets no air.
///
/// Fails with one sentence with file and line: everything that readCsv refuses, a speed or power that is negative or
/// above that of any drive, an unknown material, a time before that of the row above, or rows that span no time or more
/// than kMaxSoundLength.
[[nodiscard]] Expected<std::vector<TimedSoundState>> readSoundProfile(const std::filesystem::path& path,
                                                                      const SpindlePreset& drive,
                                                                      const MaterialTable& materials);

/// The same from memory; `name` stands for the file in messages.
[[nodiscard]] Expected<std::vector<TimedSoundState>> parseSoundProfile(std::string_view text, std::string_view name,
                                                                       const SpindlePreset& drive,
                                                                       const MaterialTable& materials);

}  // namespace tactooth
