// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/fast_motion.h"

#include <cmath>
#include <numbers>

namespace tactooth::test {
namespace {

/// Directions evenly spread over the sphere: R. Swinbank, R. J. Purser, "Fibonacci Grids", Q. J. Royal Meteorological
/// Society 132, 2006.
Vec3 spread(int i, int count) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double azimuth = 2 * std::numbers::pi * i / std::numbers::phi;
    const double radius = std::sqrt(1 - z * z);
    return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

/// Whether a straight path is free, sampled every half micrometre or closer, and closest at its start: a tool that
/// stands a tenth of a micrometre beside an edge must get over the edge. A tool cannot have reached a pose beyond a
/// wall, however thin the wall is.
bool isPathFree(const ExactIntersection& oracle, const Pose& from, const Vec3& displacement) {
    constexpr int kSamples = 80;
    for (int i = 1; i <= kSamples; ++i) {
        const double share = static_cast<double>(i * i) / (kSamples * kSamples);
        if (oracle.at({from.position + share * displacement, from.rotation})) return false;
    }
    return true;
}

/// Whether no straight path from `pose` leads nearer to the device pose by more than kExactEnough.
bool isProvenMinimum(const ExactIntersection& oracle, const Pose& pose, const Pose& device) {
    constexpr int kDirections = 400;
    const Vec3 toDevice = device.position - pose.position;
    for (const double reach : {0.003, 0.02}) {  // mm
        for (int i = 0; i < kDirections; ++i) {
            const Vec3 step = reach * spread(i, kDirections);
            if ((toDevice - step).norm() > toDevice.norm() - kExactEnough) continue;
            if (!oracle.at({pose.position + step, pose.rotation}) && isPathFree(oracle, pose, step)) return false;
        }
    }
    return true;
}

void count(SpeedReport& report, bool wrong, double error) {
    if (wrong && report.firstWrong < 0) report.firstWrong = report.ticks;
    report.wrong += wrong ? 1 : 0;
    if (wrong) report.worst = std::max(report.worst, error);
    ++report.ticks;
}

}  // namespace

std::vector<Pose> pathOver(const Vec3& place, double speed) {
    const Vec3 corners[] = {Vec3(0, 0, 2),      Vec3(0, 0, -0.4),      Vec3(1.2, 0.3, -0.4), Vec3(-1.2, -0.4, -0.4),
                            Vec3(0.2, 1, -0.1), Vec3(0.1, -0.6, -0.6), Vec3(0, 0, 2)};
    std::vector<Pose> poses;
    double into = 0;  // mm along the present leg
    for (std::size_t leg = 0; leg + 1 < std::size(corners); ++leg) {
        const Vec3 displacement = corners[leg + 1] - corners[leg];
        for (; into < displacement.norm(); into += speed * kTick) {
            const double turn = 0.35 * std::sin(3 * kTick * static_cast<double>(poses.size()));
            poses.push_back({place + corners[leg] + into * displacement.normalized(),
                             Quat(Eigen::AngleAxisd(turn, Vec3(0.6, 0.64, 0.48)))});
        }
        into -= displacement.norm();
    }
    return poses;
}

SpeedReport checkOverPatches(const TenPatches& piece, const TriangleMesh& tool, const Vec3& place, double speed) {
    const std::vector<Pose> path = pathOver(place, speed);
    const ExactIntersection oracle(piece.surface, tool);
    ProxySolver solver(toolOf(tool));
    solver.setSurface(surfaceOf(piece.surface));
    solver.placeAt(path.front());
    SpeedReport report;
    for (const Pose& device : path) {
        report.touching += solver.moveToward(device).contactCount > 0 ? 1 : 0;
        report.intersecting += oracle.at(solver.pose()) ? 1 : 0;
        const double exact = (nearestFreeTip(piece, tool, device) - device.position).norm();
        const double error = std::abs((solver.pose().position - device.position).norm() - exact);
        count(report, error > kExactEnough || !solver.pose().rotation.isApprox(device.rotation, 1e-12), error);
    }
    return report;
}

SpeedReport checkOverTooth(const TriangleMesh& tooth, const TriangleMesh& tool, double speed, int strokes,
                           int subSteps) {
    ToolTrajectory how;
    how.speed = speed;
    how.stroke = 3;
    how.strokes = strokes;
    const std::vector<Pose> path = toolTrajectory(tooth, how);
    const ExactIntersection oracle(tooth, tool);
    const auto surface = surfaceOf(tooth);
    const auto shape = toolOf(tool);
    ProxySolver solver(shape);
    ProxySolver fineSteps(shape);
    for (ProxySolver* each : {&solver, &fineSteps}) {
        each->setSurface(surface);
        each->placeAt(path.front());
    }
    SpeedReport report;
    Pose last = path.front();
    for (const Pose& device : path) {
        report.touching += solver.moveToward(device).contactCount > 0 ? 1 : 0;
        for (int i = 1; i <= subSteps; ++i) {
            const double share = static_cast<double>(i) / subSteps;
            const Vec3 position = last.position + share * (device.position - last.position);
            fineSteps.moveToward(
                {position, i == subSteps ? device.rotation : last.rotation.slerp(share, device.rotation)});
        }
        last = device;
        const double error = std::abs((solver.pose().position - device.position).norm() -
                                      (fineSteps.pose().position - device.position).norm());
        const bool turned = solver.pose().rotation.isApprox(device.rotation, 1e-12);
        count(report, !turned || (error > kExactEnough && !isProvenMinimum(oracle, solver.pose(), device)), error);
        if (report.ticks % 5 == 0) report.intersecting += oracle.at(solver.pose()) ? 1 : 0;
    }
    return report;
}

}  // namespace tactooth::test
