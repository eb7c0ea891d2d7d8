// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "geometry/util/expected.h"
#include "geometry/util/pose.h"

namespace tactooth {

/// The pose of a tool at one time.
struct TimedPose {
    double time;  ///< s
    Pose toolInTooth;
};

/// Reads a CSV file with the columns t,x,y,z,qw,qx,qy,qz (s, mm, unit quaternion).
///
/// Fails with one sentence with file and line: everything that readCsv refuses, a quaternion whose length differs from
/// 1 by more than 1 % (otherwise it is normalised), or a time before that of the row above.
[[nodiscard]] Expected<std::vector<TimedPose>> readTrajectory(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in messages.
[[nodiscard]] Expected<std::vector<TimedPose>> parseTrajectory(std::string_view text, std::string_view name);

}  // namespace tactooth
