// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/tool_trajectory.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kTick = 1e-3;          // s
constexpr double kStation = 0.1;        // mm between two samples of the height of the surface
constexpr double kStrokeSpacing = 0.3;  // mm

/// Height of the highest point of the triangle above (x, y), or `otherwise` if it is not above it.
double heightAt(const Vec3& a, const Vec3& b, const Vec3& c, double x, double y, double otherwise) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double area = ab.x() * ac.y() - ab.y() * ac.x();
    if (area == 0) return otherwise;
    const double v = ((x - a.x()) * ac.y() - (y - a.y()) * ac.x()) / area;
    const double w = (ab.x() * (y - a.y()) - ab.y() * (x - a.x())) / area;
    return v >= 0 && w >= 0 && v + w <= 1 ? a.z() + v * ab.z() + w * ac.z() : otherwise;
}

/// Points on top of the tooth along the strokes; where a sample misses the tooth, it takes the height of the one
/// before.
std::vector<Vec3> stations(const TriangleMesh& tooth, const ToolTrajectory& path) {
    const Box3 box = boundingBox(tooth);
    const int perStroke = static_cast<int>(std::ceil(path.stroke / kStation));
    std::vector<Vec3> points;
    for (int stroke = 0; stroke < path.strokes; ++stroke) {
        for (int i = 0; i <= perStroke; ++i) {
            const double along =
                path.stroke * (static_cast<double>(stroke % 2 == 0 ? i : perStroke - i) / perStroke - 0.5);
            const double beside = kStrokeSpacing * (stroke - 0.5 * (path.strokes - 1));
            points.emplace_back(box.center().x() + along, box.center().y() + beside + 0.2 * along, box.min().z());
        }
    }
    for (std::size_t i = 0; i < tooth.triangles.size(); ++i) {
        const Vec3 a = tooth.corner(i, 0);
        const Vec3 b = tooth.corner(i, 1);
        const Vec3 c = tooth.corner(i, 2);
        const Vec3 low = a.cwiseMin(b).cwiseMin(c);
        const Vec3 high = a.cwiseMax(b).cwiseMax(c);
        for (Vec3& p : points) {
            if (p.x() < low.x() || p.x() > high.x() || p.y() < low.y() || p.y() > high.y() || high.z() < p.z())
                continue;
            p.z() = std::max(p.z(), heightAt(a, b, c, p.x(), p.y(), p.z()));
        }
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].z() == box.min().z()) points[i].z() = points[i - 1].z();
    }
    return points;
}

Quat turnAt(const ToolTrajectory& path, double time) {
    const double period = 4 * path.maxRotation / path.turn;
    const double phase = std::fmod(time / period + 0.75, 1.0);
    const double angle = path.maxRotation * (4 * std::abs(phase - 0.5) - 1) * std::numbers::pi / 180;
    return Quat(Eigen::AngleAxisd(angle, Vec3(0.6, 0.64, 0.48)));
}

}  // namespace

std::vector<Pose> toolTrajectory(const TriangleMesh& tooth, const ToolTrajectory& path) {
    TACTOOTH_ASSERT(!tooth.empty());
    TACTOOTH_ASSERT(path.speed > 0 && path.stroke > 0 && path.strokes > 0);
    TACTOOTH_ASSERT(path.turn > 0 && path.maxRotation > 0);
    std::vector<Vec3> corners = stations(tooth, path);
    for (Vec3& corner : corners) corner.z() -= path.press;
    const auto above = [&](const Vec3& end) {
        const double start = path.approach > 0 ? boundingBox(tooth).max().z() + path.approach : end.z() + path.approach;
        return Vec3(end.x(), end.y(), start);
    };
    const Vec3 last = above(corners.back());
    corners.insert(corners.begin(), above(corners.front()));
    corners.push_back(last);
    std::vector<Pose> poses;
    const double step = path.speed * kTick;
    double into = 0;  // mm along the present segment
    for (std::size_t leg = 0; leg + 1 < corners.size(); ++leg) {
        const Vec3 displacement = corners[leg + 1] - corners[leg];
        const double length = displacement.norm();
        for (; into < length; into += step) {
            const double time = kTick * static_cast<double>(poses.size());
            poses.push_back({corners[leg] + into / length * displacement, turnAt(path, time)});
        }
        into -= length;
    }
    return poses;
}

}  // namespace tactooth
