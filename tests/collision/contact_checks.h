// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <vector>

#include "collision/contact_oracle.h"
#include "collision/proxy/contact_query.h"
#include "geometry/util/pose.h"

namespace tactooth::test {

/// A random pose near the tooth's upper two thirds: the tip at most `deepest` mm below or 0.2 mm above the surface, the
/// shaft within 60 degrees of the surface normal.
[[nodiscard]] inline Pose randomPoseNear(const TriangleMesh& tooth, double deepest, std::mt19937& random) {
    const Box3 box = boundingBox(tooth);
    std::uniform_int_distribution<std::size_t> anyTriangle(0, tooth.triangles.size() - 1);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> normal;
    while (true) {
        const std::size_t i = anyTriangle(random);
        const Vec3 place = (tooth.corner(i, 0) + tooth.corner(i, 1) + tooth.corner(i, 2)) / 3;
        const Vec3 area = tooth.areaVector(i);
        if (place.z() < box.min().z() + box.sizes().z() / 3 || !(area.norm() > 0)) continue;
        const Vec3 outward = area.normalized();
        const Quat upright = shortestRotation(Vec3::UnitZ(), outward);
        const Vec3 axis = Vec3(normal(random), normal(random), normal(random)).normalized();
        const Quat tilt(Eigen::AngleAxisd(unit(random) * 1.05, axis));
        const double depth = -0.2 + (deepest + 0.2) * unit(random);
        return {place - depth * outward, (tilt * upright).normalized()};
    }
}

/// The shortest exit along `directions` random directions, or `depth` if none is shorter, mm.
[[nodiscard]] inline double leastExitDistance(const Oracle& oracle, const Pose& pose, double depth, int directions,
                                              std::mt19937& random) {
    std::normal_distribution<double> normal;
    double best = depth;
    for (int i = 0; i < directions; ++i) {
        const Vec3 u = Vec3(normal(random), normal(random), normal(random)).normalized();
        const auto freeAt = [&](double s) { return oracle.isFree({pose.position + s * u, pose.rotation}); };
        if (!freeAt(0.99 * best)) continue;
        double blocked = 0;
        double clear = 0.99 * best;
        while (clear - blocked > 1e-4) {
            const double middle = (blocked + clear) / 2;
            (freeAt(middle) ? clear : blocked) = middle;
        }
        best = clear;
    }
    return best;
}

/// Errors of the touch test on a set of random poses.
struct TouchReport {
    int touching = 0;  ///< according to the oracle
    int wrong = 0;     ///< poses at which the query differs from the oracle
};

[[nodiscard]] inline TouchReport checkTouch(const TriangleMesh& tooth, const TriangleMesh& tool, int poses,
                                            unsigned seed) {
    const Oracle oracle(tooth, tool);
    ContactQuery query(toolOf(tool), surfaceOf(tooth));
    std::mt19937 random(seed);
    TouchReport report;
    for (int i = 0; i < poses; ++i) {
        const Pose pose = randomPoseNear(tooth, 0.5, random);
        const bool free = oracle.isFree(pose);
        report.touching += free ? 0 : 1;
        report.wrong += query.isFree(pose) == free ? 0 : 1;
    }
    return report;
}

/// Errors of the depth on a set of random poses.
struct ContactReport {
    int poses = 0;
    int touching = 0;
    int wrongTouch = 0;          ///< touching differs from the oracle
    int notFreed = 0;            ///< depth + 0.1 um along the normal does not free the tool
    int freedEarly = 0;          ///< depth - 0.1 um does
    std::vector<double> excess;  ///< depth over the best separation found, sorted
};

[[nodiscard]] inline ContactReport checkContact(const TriangleMesh& tooth, const TriangleMesh& tool, int poses,
                                                int directions, unsigned seed) {
    const Oracle oracle(tooth, tool);
    ContactQuery query(toolOf(tool), surfaceOf(tooth));
    std::mt19937 random(seed);
    ContactReport report;
    for (; report.poses < poses; ++report.poses) {
        const Pose pose = randomPoseNear(tooth, 0.5, random);
        const Contact contact = query.at(pose);
        report.wrongTouch += contact.touching == oracle.isFree(pose) ? 1 : 0;
        if (!contact.touching) continue;
        ++report.touching;
        const auto freeAt = [&](double s) {
            return oracle.isFree({pose.position + s * contact.normal, pose.rotation});
        };
        report.notFreed += freeAt(contact.depth + 1e-4) ? 0 : 1;
        report.freedEarly += contact.depth > 1e-4 && freeAt(contact.depth - 1e-4) ? 1 : 0;
        if (directions > 0)
            report.excess.push_back(contact.depth / leastExitDistance(oracle, pose, contact.depth, directions, random));
    }
    std::sort(report.excess.begin(), report.excess.end());
    return report;
}

/// The quantile `share` of the excess.
[[nodiscard]] inline double excessAt(const ContactReport& report, double share) {
    return report.excess[static_cast<std::size_t>(share * static_cast<double>(report.excess.size() - 1))];
}

}  // namespace tactooth::test
