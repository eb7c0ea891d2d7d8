// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/cell_qef.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "collision/narrow/lane_flags.h"
#include "geometry/util/assert.h"

// Source: T. Ju, F. Losasso, S. Schaefer, J. Warren, "Dual Contouring of Hermite Data", SIGGRAPH 2002, section 2.3.
// Differences from the paper: a cell whose planes agree, as most do, needs no eigenvalues, and its vertex lies so that
// the surface encloses the right volume. The vertex stays within a box.

namespace tactooth {
namespace {

/// An eigenvalue below this share of the largest one counts as zero: the planes have no edge in that direction, and the
/// vertex stays at the mean of the crossings. Edges sharper than about 20 degrees stay sharp.
constexpr double kFlat = 0.03;

/// How far a vertex goes from the mean of its crossings toward the point where bent planes meet. A boundary of radius r
/// bends by s = d^2 / 8r within a cell of width d: the mean lies s on one side of it, where the planes meet s on the
/// other. A polygon encloses the area of its curve with its corners 2/3 s beyond it. (At s, the walls of a hole would
/// lie s/3 too far out: 0.4 um with a bur of 0.5 mm and voxels of 0.05 mm.)
constexpr float kBentShare = 5.0F / 6;

Vec3 clamped(const Vec3& point, const Box3& bounds) { return point.cwiseMax(bounds.min()).cwiseMin(bounds.max()); }

/// Sums over the planes for the least-squares point. Offsets count from the centre.
struct Quadric {
    Mat3 products;
    Vec3 offsets;

    /// The displacement from the centre to the nearest point along the free axes (1). Held axes have 0.
    [[nodiscard]] Vec3 nearestOffset(const Vec3& held, const Vec3& free) const {
        Eigen::SelfAdjointEigenSolver<Mat3> solver;
        solver.computeDirect(free.asDiagonal() * products * free.asDiagonal());
        const Vec3 wanted = free.asDiagonal() * (offsets - products * held);
        const double largest = solver.eigenvalues()[2];
        Vec3 offset = held;
        for (int i = 0; i < 3; ++i) {
            const double value = solver.eigenvalues()[i];
            const Vec3 direction = solver.eigenvectors().col(i);
            if (value > kFlat * largest) offset += direction * (direction.dot(wanted) / value);
        }
        return offset;
    }
};

}  // namespace

void CellQef8::add(const Vec3x8& normal, const Vec3x8& point, Float8 counts) {
    const Vec3x8 n = normal * counts;
    const Vec3x8 p = point * counts;
    count_ = count_ + counts;
    points_ = points_ + p;
    normals_ = normals_ + n;
    offsets_ = offsets_ + n * dot(n, p);
    productsX_ = productsX_ + n * n.x;
    yy_ = yy_ + n.y * n.y;
    yz_ = yz_ + n.y * n.z;
}

/// The sum of the outer products of the normals, times a vector.
Vec3x8 CellQef8::timesProducts(const Vec3x8& v) const {
    const auto& [xx, xy, xz] = productsX_;
    const Float8 zz = count_ - xx - yy_;  // the normals have unit length
    return {dot(productsX_, v), dot({xy, yy_, yz_}, v), dot({xz, yz_, zz}, v)};
}

CellQef8::Flat CellQef8::flat() const {
    const Float8 along = dotAsEigen(normals_, timesProducts(normals_));
    // What the mean direction leaves of the total weight belongs to all other directions.
    const Float8 across = count_ * dotAsEigen(normals_, normals_) - along;
    const Vec3x8 centres = means();
    const Vec3x8 offsets = offsets_ - timesProducts(centres);
    return {isLess(across, Float8::all(static_cast<float>(kFlat)) * along),
            centres + normals_ * (Float8::all(kBentShare) * dotAsEigen(normals_, offsets) / along)};
}

Vec3f CellQef8::nearestPoint(int lane, const Box3& bounds) const {
    TACTOOTH_ASSERT(lane >= 0 && lane < 8);
    TACTOOTH_ASSERT(!bounds.isEmpty());
    const auto of = [lane](const Vec3x8& vectors) {
        float lanes[3][8];
        vectors.store(lanes);
        return Vec3(lanes[0][lane], lanes[1][lane], lanes[2][lane]);
    };
    const Vec3x8 centres = means();
    const Vec3 centre = of(centres);
    Quadric quadric{Mat3(), of(offsets_ - timesProducts(centres))};
    quadric.products.col(0) = of(timesProducts(Vec3x8::all(1, 0, 0)));
    quadric.products.col(1) = of(timesProducts(Vec3x8::all(0, 1, 0)));
    quadric.products.col(2) = of(timesProducts(Vec3x8::all(0, 0, 1)));
    Vec3 held = Vec3::Zero();  // displacement along the axes that are not free
    Vec3 free = Vec3::Ones();
    Vec3 offset = quadric.nearestOffset(held, free);
    for (int i = 0; i < 3 && !bounds.contains(centre + offset); ++i) {
        const Vec3 inside = clamped(centre + offset, bounds) - centre;
        int worst = 0;
        (inside - offset).cwiseAbs().maxCoeff(&worst);
        held[worst] = inside[worst];
        free[worst] = 0;
        offset = quadric.nearestOffset(held, free);
    }
    TACTOOTH_ASSERT(centre.allFinite() && offset.allFinite());
    return clamped(centre + offset, bounds).cast<float>();
}

}  // namespace tactooth
