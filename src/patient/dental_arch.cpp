// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/dental_arch.h"

#include <Eigen/Dense>

namespace tactooth {

std::optional<Vec3> archCentre(std::span<const Vec3> crowns) {
    if (crowns.size() < 3) return std::nullopt;
    Vec3 mean = Vec3::Zero();
    for (const Vec3& crown : crowns) mean += crown / static_cast<double>(crowns.size());
    Mat3 spread = Mat3::Zero();
    for (const Vec3& crown : crowns) spread += (crown - mean) * (crown - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Mat3> plane(spread);
    const Vec3 u = plane.eigenvectors().col(2), v = plane.eigenvectors().col(1);
    // x^2 + y^2 = 2 a x + 2 b y + c is linear in the centre (a, b).
    Eigen::MatrixX3d left(crowns.size(), 3);
    Eigen::VectorXd right(crowns.size());
    for (std::size_t i = 0; i < crowns.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double x = u.dot(crowns[i] - mean), y = v.dot(crowns[i] - mean);
        left.row(row) << 2 * x, 2 * y, 1;
        right[row] = x * x + y * y;
    }
    const Vec3 centre = left.colPivHouseholderQr().solve(right);
    const Vec3 middle = mean + centre.x() * u + centre.y() * v;
    // The radius of an arch is 20 to 35 mm; a much larger circle is a line.
    constexpr double kLargest = 80;  // mm
    if (!middle.allFinite() || (middle - crowns.front()).norm() > kLargest) return std::nullopt;
    return middle;
}

}  // namespace tactooth
