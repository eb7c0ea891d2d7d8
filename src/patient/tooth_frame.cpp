// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/tooth_frame.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/util/degree.h"
#include "geometry/util/pose.h"
#include "patient/messages.h"
#include "patient/tooth_sections.h"

namespace tactooth {
namespace {

constexpr double kUprightTolerance = 30 * kDegree;  // rad: teeth in a jaw lean by up to 20 degrees
constexpr double kMinElongation = 1.15;             // a body that is longer than wide by less has no long axis

struct LongAxis {
    Vec3 middle;  ///< of the surface, mm
    Vec3 axis;    ///< unit, of either sign
    bool isClear;
};

LongAxis longAxisOf(const TriangleMesh& mesh) {
    double area = 0;
    Vec3 middle = Vec3::Zero();
    Mat3 second = Mat3::Zero();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const double weight = mesh.areaVector(t).norm();
        const Vec3 sum = mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2);
        area += weight;
        middle += weight * sum / 3;
        // The moment of a whole facet, whatever its size: the axis is that of the surface, not that of its mesh.
        second += weight / 12 * sum * sum.transpose();
        for (int i = 0; i < 3; ++i) second += weight / 12 * mesh.corner(t, i) * mesh.corner(t, i).transpose();
    }
    middle /= area;
    const Eigen::SelfAdjointEigenSolver<Mat3> moments(second / area - middle * middle.transpose());
    const double ratio = std::sqrt(moments.eigenvalues()[2] / std::max(moments.eigenvalues()[1], 1e-12));
    return {middle, moments.eigenvectors().col(2), ratio > kMinElongation};
}

/// What the half of the body toward `axis` has more of the volume than the other half, as a share of the whole.
double volumeImbalance(const TriangleMesh& mesh, const Vec3& axis) {
    const Quat upright = shortestRotation(axis, Vec3::UnitZ());
    const SectionProfile profile = sectionProfile(transformed(mesh, {Vec3::Zero(), upright}));
    const auto half = profile.areas.begin() + static_cast<std::ptrdiff_t>(profile.areas.size() / 2);
    const double upper = std::accumulate(half, profile.areas.end(), 0.0);
    const double lower = std::accumulate(profile.areas.begin(), half, 0.0);
    return (upper - lower) / (upper + lower);
}

/// The rotation of the file's frame that brings `crown` up and, among those, `buccal` closest to +y.
Quat uprightRotation(const Vec3& crown, const Vec3& buccal) {
    const Vec3 x = buccal.cross(crown).normalized();
    Mat3 rows;
    rows.row(0) = x;
    rows.row(1) = crown.cross(x);
    rows.row(2) = crown;
    return Quat(rows).normalized();
}

struct Orientation {
    Quat upright;  ///< rotates the file's directions into those of the tooth
    std::vector<ImportNote> why;
};

double angleFromZ(const Vec3& direction) { return std::acos(std::clamp(direction.z(), -1.0, 1.0)); }

Vec3 crownDirection(const TriangleMesh& outer, const FrameHints& hints, const LongAxis& shape,
                    std::vector<ImportNote>& why) {
    const auto add = [&](const MessageText& text) { why.push_back({ImportNoteTopic::Orientation, text}); };
    Vec3 axis = shape.isClear ? shape.axis : Vec3::UnitZ();
    if (!shape.isClear) {
        add(msg::kNoteNoLongAxis);
    } else if (hints.crown) {
        if (axis.dot(*hints.crown) < 0) axis = -axis;
        add(msg::kNoteCrownAtEnamel);
    } else {
        if (volumeImbalance(outer, axis) < 0) axis = -axis;
        add(msg::kNoteCrownThicker);
    }
    return axis;
}

Orientation orientationOf(const TriangleMesh& outer, const FrameHints& hints, const LongAxis& shape) {
    Orientation orientation;
    const auto add = [&](Message message) {
        orientation.why.push_back({ImportNoteTopic::Orientation, std::move(message)});
    };
    const Vec3 crown = crownDirection(outer, hints, shape, orientation.why);
    const double tilt = angleFromZ(crown);
    constexpr double kClear = 0.2;  // sine of the angle to the long axis: a smaller one gives no buccal direction
    if (hints.buccal && hints.buccal->cross(crown).norm() > kClear * hints.buccal->norm()) {
        orientation.upright = uprightRotation(crown, *hints.buccal);
        add(msg::kNoteCheekOutward);
    } else if (tilt < kUprightTolerance) {
        orientation.upright = Quat::Identity();
        add({msg::kNoteUpright, rounded(tilt / kDegree, 0)});
    } else {
        orientation.upright = shortestRotation(crown, Vec3::UnitZ());
        add({msg::kNoteTurnedUpright, rounded(tilt / kDegree, 0)});
    }
    return orientation;
}

}  // namespace

FrameGuess guessToothFrame(const TriangleMesh& outer, const FrameHints& hints) {
    const LongAxis shape = longAxisOf(outer);
    Orientation orientation = orientationOf(outer, hints, shape);
    Quat upright = orientation.upright;
    if (hints.isFlipped) {
        upright = Quat(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitY())) * upright;
        orientation.why.push_back({ImportNoteTopic::Orientation, msg::kNoteUpsideDown});
    }
    if (hints.turn != 0) {
        upright = Quat(Eigen::AngleAxisd(hints.turn, Vec3::UnitZ())) * upright;
        orientation.why.push_back(
            {ImportNoteTopic::Orientation, {msg::kNoteTurnedAbout, rounded(hints.turn / kDegree, 0)}});
    }
    const TriangleMesh turned = transformed(outer, {Vec3::Zero(), upright});
    Vec3 origin = upright * shape.middle;
    origin.z() = neckHeight(sectionProfile(turned));
    const Quat back = upright.conjugate();
    return {{back * origin, back}, std::move(orientation.why)};
}

std::optional<double> crownTilt(const TriangleMesh& outer) {
    const LongAxis shape = longAxisOf(outer);
    if (!shape.isClear) return std::nullopt;
    constexpr double kClear = 0.05;  // both ends of a body with less count as equally thick
    const double imbalance = volumeImbalance(outer, shape.axis);
    if (std::abs(imbalance) < kClear) return std::nullopt;
    return angleFromZ(imbalance < 0 ? Vec3(-shape.axis) : shape.axis);
}

std::optional<ImportNote> noteOnTilt(const TriangleMesh& outer) {
    const std::optional<double> tilt = crownTilt(outer);
    if (!tilt || *tilt < kUprightTolerance) return std::nullopt;
    return ImportNote{ImportNoteTopic::Orientation, {msg::kNoteTilted, rounded(*tilt / kDegree, 0)}};
}

}  // namespace tactooth
