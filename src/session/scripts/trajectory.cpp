// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/scripts/trajectory.h"

#include <array>
#include <cmath>

#include "geometry/util/number_text.h"
#include "session/io/csv_table.h"
#include "session/io/messages.h"

namespace tactooth {
namespace {

constexpr std::array<std::string_view, 8> kColumns = {"t", "x", "y", "z", "qw", "qx", "qy", "qz"};
constexpr double kFarthest = 1e4;        // mm
constexpr double kLatest = 1e12;         // s: 30,000 years, with steps of 0.1 ms
constexpr double kUnitTolerance = 0.01;  // so that quaternions with three digits are accepted

Expected<std::vector<TimedPose>> posesOf(const Expected<CsvTable>& table) {
    if (!table) return Unexpected{table.error()};
    std::vector<TimedPose> trajectory;
    trajectory.reserve(table->rows());
    for (std::size_t row = 0; row < table->rows(); ++row) {
        const auto value = table->row(row);
        const Quat rotation(value[4], value[5], value[6], value[7]);
        const double length = rotation.norm();
        if (std::abs(length - 1) > kUnitTolerance) {
            return unexpected(msg::kQuaternionLength, table->where(row), numberText(length));
        }
        if (Vec3(value[1], value[2], value[3]).cwiseAbs().maxCoeff() > kFarthest) {
            return unexpected(msg::kToolTooFar, table->where(row));
        }
        if (std::abs(value[0]) > kLatest) {
            return unexpected(msg::kTimeTooLarge, table->where(row));
        }
        if (row > 0 && value[0] < trajectory.back().time) {
            return unexpected(msg::kTimeBackwards, table->where(row));
        }
        trajectory.push_back({value[0], {Vec3(value[1], value[2], value[3]), rotation.normalized()}});
    }
    return trajectory;
}

}  // namespace

Expected<std::vector<TimedPose>> readTrajectory(const std::filesystem::path& path) {
    return posesOf(readCsv(path, kColumns));
}

Expected<std::vector<TimedPose>> parseTrajectory(std::string_view text, std::string_view name) {
    return posesOf(parseCsv(text, name, kColumns));
}

}  // namespace tactooth
