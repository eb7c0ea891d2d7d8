// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Fit to a real tooth: P. J. Besl, N. D. McKay, "A method for registration of 3-D shapes", IEEE PAMI 14 (1992), here
// with a scale for each axis of the tooth; rotations by W. Kabsch, Acta Cryst. A32 (1976).
#include "instruments/real_crowns.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "collision/bvh/closest_point.h"
#include "instruments/relief_map.h"

namespace tactooth::test {
namespace {

/// A map of a real tooth's points to the model's frame.
struct Fit {
    Mat3 turn = Mat3::Identity();
    Vec3 scale = Vec3::Ones(), shift = Vec3::Zero();  ///< p -> scale * (turn p) + shift

    [[nodiscard]] Vec3 operator()(const Vec3& p) const { return scale.cwiseProduct(turn * p) + shift; }
    [[nodiscard]] Vec3 inverse(const Vec3& p) const { return turn.transpose() * (p - shift).cwiseQuotient(scale); }
};

/// The fit of `from` to `to`, nearer than `last`: first the rotation, then the scales.
Fit fitted(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to, const Fit& last) {
    Fit fit;
    const Vec3 middleFrom = from.rowwise().mean(), middleTo = to.rowwise().mean();
    const Eigen::Matrix3Xd b = to.colwise() - middleTo;
    const Mat3 products = last.scale.cwiseInverse().asDiagonal() * b * (from.colwise() - middleFrom).transpose();
    const Eigen::JacobiSVD<Mat3> svd(products, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double side = svd.matrixU().determinant() * svd.matrixV().determinant();
    fit.turn = svd.matrixU() * Vec3(1, 1, side).asDiagonal() * svd.matrixV().transpose();
    const Eigen::Matrix3Xd a = fit.turn * (from.colwise() - middleFrom);
    fit.scale = a.cwiseProduct(b).rowwise().sum().cwiseQuotient(a.cwiseProduct(a).rowwise().sum());
    constexpr double kMost = 1.25;  // between two adults
    fit.scale = fit.scale.cwiseMax(1 / kMost).cwiseMin(kMost);
    fit.shift = middleTo - fit.scale.cwiseProduct(fit.turn * middleFrom);
    return fit;
}

/// The best fit from a start, and the root mean square of the distances that it leaves.
std::pair<double, Fit> bestFit(const Eigen::Matrix3Xd& model, const SurfacePart& real, Fit fit) {
    constexpr int kRounds = 60;
    double square = 0;
    Eigen::Matrix3Xd nearest(3, model.cols());
    for (int round = 0; round <= kRounds; ++round) {
        square = 0;
        for (Eigen::Index i = 0; i < model.cols(); ++i) {
            nearest.col(i) = closestPoint(real, fit.inverse(model.col(i)))->point;
            square += (fit(nearest.col(i)) - model.col(i)).squaredNorm();
        }
        fit = fitted(nearest, model, fit);
    }
    return {std::sqrt(square / static_cast<double>(model.cols())), fit};
}

/// Points of the crown above a height, about evenly spread over the order of the vertices.
Eigen::Matrix3Xd crownPoints(const TriangleMesh& mesh, double from) {
    std::vector<Vec3> crown;
    for (const Vec3f& vertex : mesh.vertices) {
        if (vertex.z() > from) crown.push_back(vertex.cast<double>());
    }
    constexpr std::size_t kPoints = 500;
    const std::size_t step = std::max<std::size_t>(1, crown.size() / kPoints);
    Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(crown.size() / step));
    for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = crown[static_cast<std::size_t>(i) * step];
    return points;
}

/// The inner part of a face: without the rim, where it falls steeply.
double reliefDistance(const TriangleMesh& model, const TriangleMesh& real, CrownFace face, double from) {
    const int across = face == CrownFace::Occlusal ? 1 : 2, toward = 3 - across;
    const double sign = face == CrownFace::Occlusal ? 1 : -1;
    Box3 crown;
    for (const Vec3f& vertex : model.vertices) {
        if (vertex.z() > from) crown.extend(vertex.cast<double>());
    }
    constexpr double kInner = 0.36;  // of the size, to both sides of the middle
    const Vec2 middle(crown.center().x(), crown.center()[across]),
        half = kInner * Vec2(crown.sizes().x(), crown.sizes()[across]);
    return reliefDifference(ReliefMap(model, 0, across, toward, sign), ReliefMap(real, 0, across, toward, sign),
                            {middle - half, middle + half});
}

}  // namespace

RealDistance distanceFromReal(const TriangleMesh& model, const TriangleMesh& real, CrownFace face, double from) {
    const Eigen::Matrix3Xd points = crownPoints(model, from);
    const SurfacePart part(real);
    const Box3 modelBox = boundingBox(model), realBox = boundingBox(real);
    std::pair<double, Fit> best(1e9, {});
    constexpr int kStarts = 8;
    for (int i = 0; i < kStarts; ++i) {
        Fit start;
        start.turn = Eigen::AngleAxisd(2 * std::numbers::pi * i / kStarts, Vec3::UnitZ()).toRotationMatrix();
        start.shift = Vec3(0, 0, modelBox.max().z() - realBox.max().z());
        const Vec3 middle = start.turn * realBox.center();
        start.shift.head<2>() = -middle.head<2>();
        const auto fit = bestFit(points, part, start);
        if (fit.first < best.first) best = fit;
    }
    TriangleMesh moved = real;
    for (Vec3f& vertex : moved.vertices) vertex = best.second(vertex.cast<double>()).cast<float>();
    return {best.first, reliefDistance(model, moved, face, from)};
}

}  // namespace tactooth::test
