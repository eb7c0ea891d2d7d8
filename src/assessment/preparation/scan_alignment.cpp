// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/scan_alignment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "collision/bvh/closest_point.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

constexpr std::size_t kPoints = 6000;  // half a second for twenty rounds
constexpr double kTrimmed = 0.2;       // share of the worst points that never count
constexpr double kUnprepared = 0.2;    // mm: points farther away are prepared
constexpr double kLeastShare = 0.3;    // of the points, that lie on the uncut tooth
constexpr double kSettled = 1e-5;      // mm: the surface moves no more
constexpr int kRounds = 60;
constexpr double kGolden = 0.6180339887498949;
constexpr std::size_t kGrain = 64;  // points: about half a millisecond

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Points spread evenly over the area of a mesh, whatever its triangles.
std::vector<Vec3> pointsOn(const TriangleMesh& mesh) {
    std::vector<double> areas(mesh.triangles.size());
    double all = 0;
    for (std::size_t i = 0; i < areas.size(); ++i) areas[i] = all += mesh.areaVector(i).norm() / 2;
    std::vector<Vec3> points;
    if (!(all > 0)) return points;
    for (std::size_t k = 0; k < kPoints; ++k) {
        const double at = (static_cast<double>(k) + 0.5) / kPoints * all;
        const auto i = static_cast<std::size_t>(std::ranges::upper_bound(areas, at) - areas.begin());
        if (i >= areas.size()) continue;
        const double before = i == 0 ? 0 : areas[i - 1];
        double a = (at - before) / (areas[i] - before);
        double b = kGolden * static_cast<double>(k) - std::floor(kGolden * static_cast<double>(k));
        if (a + b > 1) {
            a = 1 - a;
            b = 1 - b;
        }
        points.push_back(mesh.corner(i, 0) + a * (mesh.corner(i, 1) - mesh.corner(i, 0)) +
                         b * (mesh.corner(i, 2) - mesh.corner(i, 0)));
    }
    return points;
}

/// A point of the scan in the tooth's frame, and what is nearest to it.
struct Match {
    Vec3 point, nearest, normal;
    double distance;
};

class Aligner {
public:
    Aligner(const TriangleMesh& scan, const SurfacePart& original) : points_(pointsOn(scan)), original_(original) {}

    [[nodiscard]] bool isEmpty() const { return points_.empty() || original_.tree().empty(); }

    /// The nearest matches first.
    [[nodiscard]] std::vector<Match> matches(const Pose& pose) const {
        std::vector<Match> all(points_.size());
        parallelFor(
            all.size(),
            [&](std::size_t i) {
                const Vec3 point = pose * points_[i];
                const ClosestPoint near = *closestPoint(original_, point);
                const Vec3 normal = original_.mesh().areaVector(near.triangle).stableNormalized();
                all[i] = {point, near.point, normal, near.distance};
            },
            kGrain);
        std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
        all.resize(static_cast<std::size_t>(static_cast<double>(all.size()) * (1 - kTrimmed)));
        return all;
    }

    /// The same without those of the prepared part.
    [[nodiscard]] std::vector<Match> unprepared(const Pose& pose) const {
        std::vector<Match> all = matches(pose);
        std::erase_if(all, [](const Match& match) { return match.distance > kUnprepared; });
        return all;
    }

    [[nodiscard]] ScanFit fitAt(const Pose& pose) const {
        const std::vector<Match> used = unprepared(pose);
        double squares = 0;
        for (const Match& match : used) squares += match.distance * match.distance;
        if (used.empty()) return {kUnprepared, 0};
        const auto count = static_cast<double>(used.size());
        return {std::sqrt(squares / count), count / static_cast<double>(points_.size())};
    }

    [[nodiscard]] Pose settle(Pose pose, bool onlyUnprepared) const {
        for (int round = 0; round < kRounds; ++round) {
            const std::vector<Match> used = onlyUnprepared ? unprepared(pose) : matches(pose);
            if (used.size() < 10) return pose;
            double moved = 0;
            pose = step(used, moved) * pose;
            if (moved < kSettled) break;
        }
        return pose;
    }

private:
    /// The small motion that brings the points nearest to the planes of their matches; `moved`: how far they go, mm.
    static Pose step(const std::vector<Match>& used, double& moved) {
        Vec3 middle = Vec3::Zero();
        for (const Match& match : used) middle += match.point / static_cast<double>(used.size());
        Matrix6 normal = Matrix6::Zero();
        Vector6 right = Vector6::Zero();
        double radius = 0;
        for (const Match& match : used) {
            const Vec3 arm = match.point - middle;
            radius = std::max(radius, arm.norm());
            Vector6 row;
            row << arm.cross(match.normal), match.normal;
            normal += row * row.transpose();
            right -= row * match.normal.dot(match.point - match.nearest);
        }
        // A body of revolution may turn freely: a little stiffness keeps it where it is.
        normal.diagonal().array() += 1e-9 * normal.trace();
        const Vector6 motion = normal.ldlt().solve(right);
        const Vec3 turn = motion.head<3>(), shift = motion.tail<3>();
        moved = turn.norm() * radius + shift.norm();
        const double angle = turn.norm();
        const Quat rotation = angle > 0 ? Quat(Eigen::AngleAxisd(angle, turn / angle)) : Quat(Quat::Identity());
        return {middle + shift - rotation * middle, rotation};
    }

    std::vector<Vec3> points_;
    const SurfacePart& original_;
};

}  // namespace

bool ScanFit::isGood() const { return residual <= kMostResidual && usedShare >= kLeastShare; }

ScanFit fitOf(const TriangleMesh& scan, const SurfacePart& original) {
    const Aligner aligner(scan, original);
    return aligner.isEmpty() ? ScanFit{kUnprepared, 0} : aligner.fitAt({});
}

ScanAlignment alignScan(const TriangleMesh& scan, const SurfacePart& original) {
    const Aligner aligner(scan, original);
    if (aligner.isEmpty()) return {{}, {kUnprepared, 0}};
    const Vec3 between = original.tree().box().center() - boundingBox(scan).center();
    ScanAlignment best;
    best.fit = {kUnprepared, 0};
    for (const Vec3& start : {Vec3(Vec3::Zero()), Vec3(between)}) {
        const Pose pose = aligner.settle(aligner.settle({start, Quat::Identity()}, false), true);
        const ScanFit fit = aligner.fitAt(pose);
        const bool isBetter = fit.isGood() != best.fit.isGood() ? fit.isGood() : fit.residual < best.fit.residual;
        if (isBetter) best = {pose, fit};
    }
    return best;
}

}  // namespace tactooth
