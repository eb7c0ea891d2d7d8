// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/cell_planes.h"

#include <Eigen/Eigenvalues>
#include <cmath>

// The quadric of T. Ju, F. Losasso, S. Schaefer, J. Warren, "Dual Contouring of Hermite Data", SIGGRAPH 2002, section
// 2.3. Differs from the paper: a cell whose planes agree, as most do, needs no eigenvalues; and the vertex is kept in a
// room.

namespace tactooth {
namespace {

/// Directions in which the planes of a cell agree to this share of their weight are not an edge: the vertex stays at
/// the mean of the crossings there. Keeps edges sharper than about 20 degrees.
constexpr double kFlat = 0.03;

Vec3 clamped(const Vec3& point, const Box3& room) { return point.cwiseMax(room.min()).cwiseMin(room.max()); }

/// The least-squares point of planes, told by the sums over them; offsets count from the centre.
struct Quadric {
    Mat3 products;
    Vec3 offsets;

    /// The way from the centre to the nearest point, along axes that are free (1) or held (0).
    [[nodiscard]] Vec3 nearestWay(const Vec3& held, const Vec3& free) const {
        Eigen::SelfAdjointEigenSolver<Mat3> solver;
        solver.computeDirect(free.asDiagonal() * products * free.asDiagonal());
        const Vec3 wanted = free.asDiagonal() * (offsets - products * held);
        const double largest = solver.eigenvalues()[2];
        Vec3 way = held;
        for (int i = 0; i < 3; ++i) {
            const double value = solver.eigenvalues()[i];
            const Vec3 direction = solver.eigenvectors().col(i);
            if (value > kFlat * largest) way += direction * (direction.dot(wanted) / value);
        }
        return way;
    }
};

}  // namespace

/// The sum of the normals' products with themselves, times a vector.
Vec3f CellPlanes::timesProducts(const Vec3f& v) const {
    const float xx = linear_[3];
    const float xy = products_[0];
    const float xz = products_[1];
    const float yy = products_[2];
    const float yz = products_[3];
    const float zz = ofPoints_[3] - xx - yy;  // the normals are of unit length
    return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
            xz * v.x() + yz * v.y() + zz * v.z()};
}

std::optional<Vec3f> CellPlanes::pointOfFlat() const {
    const Vec3f sum = linear_.head<3>().matrix();
    const float squared = sum.squaredNorm();
    const float along = sum.dot(timesProducts(sum));
    // The weight in all other directions together is what the mean one leaves of the planes'.
    if (!(ofPoints_[3] * squared - along < static_cast<float>(kFlat) * along)) return std::nullopt;
    const Vec3f centre = mean();
    return Vec3f(centre + sum * (sum.dot(offsetsFrom(centre)) / along));
}

Vec3f CellPlanes::nearestPoint(const Box3& room) const {
    const Vec3 centre = mean().cast<double>();
    Quadric quadric{Mat3(), offsetsFrom(mean()).cast<double>()};
    for (int i = 0; i < 3; ++i) quadric.products.col(i) = timesProducts(Vec3f::Unit(i)).cast<double>();
    Vec3 held = Vec3::Zero();  // how far the centre is moved along the axes that are not free
    Vec3 free = Vec3::Ones();
    Vec3 way = quadric.nearestWay(held, free);
    for (int i = 0; i < 3 && !room.contains(centre + way); ++i) {
        const Vec3 inside = clamped(centre + way, room) - centre;
        int worst = 0;
        (inside - way).cwiseAbs().maxCoeff(&worst);
        held[worst] = inside[worst];
        free[worst] = 0;
        way = quadric.nearestWay(held, free);
    }
    return clamped(centre + way, room).cast<float>();
}

}  // namespace tactooth
