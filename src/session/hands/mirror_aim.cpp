// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/mirror_aim.h"

#include <array>
#include <cmath>
#include <numbers>

#include "geometry/util/degree.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

// The places on the shaft that are to be seen, mm above the tip: a bur's head, and where it meets the tooth.
constexpr std::array kHeights = {0.2, 0.7, 1.2, 2.0, 3.0};
constexpr std::array kDistances = {11.0, 9.0, 13.0, 16.0};  // mm from tip to glass: as it is held, first choice first
constexpr double kGrazing = 0.35;                           // cosine to the glass; flatter the picture is a slit
constexpr double kStem = 25;                                // mm of the stem that must be free
constexpr int kRimPoints = 12;

/// Whether nothing of the mouth is between two places.
bool isFree(const Surface& mouth, const Vec3& from, const Vec3& to) {
    const Vec3 path = to - from;
    const double length = path.norm();
    if (!(length > 0)) return true;
    const std::optional<double> hit = firstHit(mouth, {from, path / length});
    return !hit || *hit > length;
}

/// Frame of a mirror whose glass faces `normal` and whose handle leaves as near to `handle` as the glass allows, then
/// turned by `angle`, rad, about the normal.
Quat mirrorRotation(const Vec3& normal, const Vec3& handle, double angle) {
    Vec3 along = handle - handle.dot(normal) * normal;
    if (along.norm() < 1e-3) along = normal.unitOrthogonal();
    along.normalize();
    Mat3 axes;
    axes << along, normal.cross(along), normal;
    return Quat(Eigen::AngleAxisd(angle, normal)) * Quat(axes);
}

bool clearsMouth(const Pose& mirror, double radius, const Surface& mouth) {
    constexpr double kAir = 0.8;  // mm between glass and tooth
    const Vec3 x = mirror.rotation * Vec3::UnitX();
    const Vec3 y = mirror.rotation * Vec3::UnitY();
    const Vec3 z = mirror.rotation * Vec3::UnitZ();
    const auto rim = [&](int i) -> Vec3 {
        const double angle = 2 * std::numbers::pi * i / kRimPoints;
        return mirror.position + (radius + kAir) * (std::cos(angle) * x + std::sin(angle) * y);
    };
    for (int i = 0; i < kRimPoints; ++i) {  // spokes, and the rim between them
        if (!isFree(mouth, mirror.position, rim(i)) || !isFree(mouth, rim(i), rim(i + 1))) return false;
    }
    if (!isFree(mouth, mirror.position - kAir * z, mirror.position + kAir * z)) return false;
    const Vec3 stem = (x - z).normalized();  // 45 degrees behind the glass
    return isFree(mouth, mirror.position, mirror.position + kStem * stem);
}

/// A mirror at `centre` that shows the middle of the bur's head to the eye; none if it would be seen edge on, or if it
/// would go through something however the handle leaves.
std::optional<Pose> mirrorAt(const Vec3& centre, const MirrorAim& aim, const Surface& mouth) {
    const Vec3 middle = aim.tip + kHeights[kHeights.size() / 2] * aim.shaft;
    const Vec3 toHead = (middle - centre).normalized();
    const Vec3 normal = (toHead + (aim.eye - centre).normalized()).normalized();
    if (!(normal.dot(toHead) > kGrazing)) return std::nullopt;
    for (const double degrees : {0.0, 25.0, -25.0, 50.0, -50.0, 80.0, -80.0}) {
        const Pose mirror{centre, mirrorRotation(normal, aim.handle, degrees * kDegree)};
        if (clearsMouth(mirror, aim.radius, mouth)) return mirror;
    }
    return std::nullopt;
}

}  // namespace

double seenByMirror(const MirrorAim& aim, const Pose& mirror, const Surface& mouth) {
    const Vec3 normal = mirror.rotation * Vec3::UnitZ();
    const double eyeHeight = (aim.eye - mirror.position).dot(normal);
    if (!(eyeHeight > 0)) return 0;  // it looks at the back
    const Vec3 image = aim.eye - 2 * eyeHeight * normal;
    int seen = 0;
    for (const double height : kHeights) {
        const Vec3 place = aim.tip + height * aim.shaft;
        const double above = (place - mirror.position).dot(normal);
        if (!(above > 0)) continue;
        const Vec3 onGlass = place + above / (above + eyeHeight) * (image - place);
        if ((onGlass - mirror.position).norm() > aim.radius) continue;
        if (isFree(mouth, place, onGlass) && isFree(mouth, onGlass, aim.eye)) ++seen;
    }
    return static_cast<double>(seen) / static_cast<double>(kHeights.size());
}

/// Tries places on spheres around the bur. The best shows most of the head and is nearest to straight behind it.
std::optional<Pose> mirrorPoseBehind(const MirrorAim& aim, const Surface& mouth) {
    constexpr double kLift = 25 * kDegree;  // of the ideal place: over the edge of a cavity
    const Vec3 away = [&] {
        const Vec3 back = aim.tip - aim.eye;
        const Vec3 level = back - back.dot(aim.shaft) * aim.shaft;
        return level.norm() > 1e-3 ? Vec3(level.normalized()) : Vec3(aim.shaft.unitOrthogonal());
    }();
    const Vec3 side = aim.shaft.cross(away);
    const auto direction = [&](double azimuth, double lift) -> Vec3 {
        return std::cos(lift) * (std::cos(azimuth) * away + std::sin(azimuth) * side) + std::sin(lift) * aim.shaft;
    };
    std::optional<Pose> best;
    double bestScore = 0;
    for (int azimuth = -80; azimuth <= 80; azimuth += 10) {
        for (int lift = -20; lift <= 60; lift += 10) {
            const Vec3 to = direction(azimuth * kDegree, lift * kDegree);
            for (const double distance : kDistances) {
                const Vec3 centre = aim.tip + distance * to;
                const std::optional<Pose> mirror = mirrorAt(centre, aim, mouth);
                if (!mirror) continue;
                constexpr double kWeightOfBehind = 0.4, kPerMm = 0.01;
                const double behind = to.dot(direction(0, kLift));
                const double farther = std::abs(distance - kDistances.front());
                const double score = seenByMirror(aim, *mirror, mouth);
                if (score <= 0) continue;
                const double worth = score + kWeightOfBehind * behind - kPerMm * farther;
                if (best && worth <= bestScore) continue;
                best = mirror;
                bestScore = worth;
            }
        }
    }
    return best;
}

std::optional<Pose> mirrorPoseOverCrown(MirrorAim aim, const Box3& tooth, const Surface& mouth) {
    const Vec3 above(tooth.center().x(), tooth.center().y(), tooth.max().z() + 1);
    const std::optional<double> down = firstHit(mouth, {above, -Vec3::UnitZ()});
    if (!down) return std::nullopt;
    aim.tip = above - *down * Vec3::UnitZ();
    aim.shaft = Vec3::UnitZ();
    return mirrorPoseBehind(aim, mouth);
}

}  // namespace tactooth
