// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/instrument_poses.h"

#include <cmath>
#include <numbers>

namespace tactooth {
namespace {

constexpr ViewDirection kView{1.25, 0.62};  // for a tooth whose mesial side is at +x

}  // namespace

Quat uprightGrip(double mesialX, double towardLingual) {
    const double angle = mesialX < 0 ? std::numbers::pi + towardLingual : -towardLingual;
    return Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
}

Pose parkedMirror(const Box3& tooth, const Vec3& toEye, double mesialX) {
    constexpr double kBehind = 8;      // mm between the tooth and the glass: room for a bur, and for a view into it
    constexpr double kAside = 6;       // mm to distal: beside the instrument, not behind it
    constexpr double kBelowTop = 3.5;  // mm from the crown's top down to the middle of its lingual side
    const Vec3 centre(tooth.center().x() - mesialX * kAside, tooth.min().y() - kBehind, tooth.max().z() - kBelowTop);
    const Vec3 lingual(tooth.center().x(), tooth.min().y(), tooth.max().z() - kBelowTop);
    const Vec3 normal = ((lingual - centre).normalized() + toEye).normalized();
    // The handle leaves along the frame's +x: as near to distal as the tilt of the glass allows.
    const Vec3 distal = -mesialX * Vec3::UnitX();
    const Vec3 handle = (distal - distal.dot(normal) * normal).normalized();
    Mat3 axes;
    axes << handle, normal.cross(handle), normal;
    return {centre, Quat(axes)};
}

Pose parkedSuction(const Box3& tooth, double mesialX) {
    constexpr double kBeside = 3.5, kBuccal = 2.0, kBelowTop = 0.5;  // mm from the crown
    const Vec3 opening(mesialX > 0 ? tooth.min().x() - kBeside : tooth.max().x() + kBeside,
                       tooth.center().y() + kBuccal, tooth.max().z() - kBelowTop);
    const Vec3 away = Vec3(-0.80 * mesialX, 0.25, 0.55).normalized();
    return {opening, shortestRotation(Vec3::UnitZ(), away)};
}

ViewDirection dentistView(double mesialX) {
    return mesialX < 0 ? ViewDirection{std::numbers::pi - kView.azimuth, kView.elevation} : kView;
}

Vec3 directionToEye(const ViewDirection& view) {
    return {std::cos(view.elevation) * std::cos(view.azimuth), std::cos(view.elevation) * std::sin(view.azimuth),
            std::sin(view.elevation)};
}

}  // namespace tactooth
