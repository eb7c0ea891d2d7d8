// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/mirror_sight.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "journal/codec/integer_columns.h"
#include "session/kernel/tick_input.h"

namespace tactooth {
namespace {

constexpr std::size_t kColumns = 13;  // tick, shown, position, rotation, radius, eye
constexpr double kLargest = 100;      // mm: no mouth has room for such a glass
constexpr std::int64_t kFarthest = static_cast<std::int64_t>(1e6 / TickInput::kPositionStep);

Vec3 placeOf(const std::array<std::int64_t, 3>& steps) {
    return TickInput::kPositionStep *
           Vec3(static_cast<double>(steps[0]), static_cast<double>(steps[1]), static_cast<double>(steps[2]));
}

std::optional<MirrorMoment> momentOf(std::span<const IntegerColumn> columns, std::size_t row) {
    const auto value = [&](std::size_t column) { return columns[column].values[row]; };
    const auto isNear = [&](std::size_t column) { return value(column) >= -kFarthest && value(column) <= kFarthest; };
    if (value(0) < 0 || value(1) < 0 || value(1) > 1) return std::nullopt;
    MirrorMoment moment{static_cast<std::uint64_t>(value(0)), {.isShown = value(1) == 1}};
    for (std::size_t i = 0; i < 3; ++i) {
        if (!isNear(2 + i) || !isNear(10 + i)) return std::nullopt;
        moment.sight.position[i] = value(2 + i);
        moment.sight.eye[i] = value(10 + i);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        if (!std::in_range<std::int32_t>(value(5 + i))) return std::nullopt;
        moment.sight.rotation[i] = static_cast<std::int32_t>(value(5 + i));
    }
    if (value(9) < 0 || !isNear(9)) return std::nullopt;
    moment.sight.radius = value(9);
    return moment;
}

}  // namespace

MirrorSight MirrorSight::of(const Pose& mirror, double radius, const Vec3& eye) {
    const TickInput held = TickInput::of({.deviceInTooth = mirror}, 0);
    const TickInput seen = TickInput::of({.deviceInTooth = Pose{eye, Quat::Identity()}}, 0);
    if (!held.hasPose || !seen.hasPose || !(radius > 0 && radius < kLargest)) return {};
    return {true, held.position, held.rotation, std::llround(radius / TickInput::kPositionStep), seen.position};
}

Pose MirrorSight::mirror() const {
    const auto part = [this](std::size_t i) { return TickInput::kRotationStep * rotation[i]; };
    return {placeOf(position), Quat(part(3), part(0), part(1), part(2)).normalized()};
}

double MirrorSight::radiusMm() const { return TickInput::kPositionStep * static_cast<double>(radius); }

Vec3 MirrorSight::eyePlace() const { return placeOf(eye); }

bool MirrorSight::shows(const Vec3& place) const {
    if (!isShown || !place.allFinite()) return false;
    const Pose glass = mirror();
    const Vec3 normal = glass.rotation * Vec3::UnitZ(), from = eyePlace();
    const double toEye = normal.dot(from - glass.position), toPlace = normal.dot(place - glass.position);
    if (!(toEye > 0 && toPlace > 0)) return false;
    const Vec3 image = place - 2 * toPlace * normal;
    const Vec3 meeting = from + toEye / (toEye + toPlace) * (image - from);
    return (meeting - glass.position).norm() <= radiusMm();
}

std::vector<std::byte> encodeMirror(std::span<const MirrorMoment> moments) {
    std::vector<IntegerColumn> columns(kColumns, {Differences::First, {}});
    for (const MirrorMoment& each : moments) {
        const MirrorSight& s = each.sight;
        const std::array<std::int64_t, kColumns> row = {static_cast<std::int64_t>(each.tick),
                                                        s.isShown ? 1 : 0,
                                                        s.position[0],
                                                        s.position[1],
                                                        s.position[2],
                                                        s.rotation[0],
                                                        s.rotation[1],
                                                        s.rotation[2],
                                                        s.rotation[3],
                                                        s.radius,
                                                        s.eye[0],
                                                        s.eye[1],
                                                        s.eye[2]};
        for (std::size_t i = 0; i < kColumns; ++i) columns[i].values.push_back(row[i]);
    }
    ByteWriter out;
    putColumns(out, columns);
    return out.take();
}

std::optional<std::vector<MirrorMoment>> decodeMirror(std::span<const std::byte> payload) {
    ByteReader in(payload);
    const std::vector<IntegerColumn> columns = getColumns(in);
    if (!in.ok() || in.left() > 0 || columns.size() != kColumns) return std::nullopt;
    std::vector<MirrorMoment> moments;
    for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
        const std::optional<MirrorMoment> moment = momentOf(columns, row);
        if (!moment || (!moments.empty() && moment->tick < moments.back().tick)) return std::nullopt;
        moments.push_back(*moment);
    }
    return moments;
}

}  // namespace tactooth
