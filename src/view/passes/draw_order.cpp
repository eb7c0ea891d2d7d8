// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/draw_order.h"

#include <algorithm>
#include <numeric>

namespace tactooth {
namespace {

/// Of the farthest corner of the box. A pose keeps distances.
double farthest(const PlacedBox& body, const Vec3& eye) {
    const Vec3 eyeInObject = (body.objectToWorld.inverse() * eye.homogeneous()).head<3>();
    return (eyeInObject - body.box.min()).cwiseAbs().cwiseMax((eyeInObject - body.box.max()).cwiseAbs()).norm();
}

}  // namespace

std::vector<std::size_t> nearestFirst(std::span<const PlacedBox> bodies, const Vec3& eye) {
    std::vector<double> distances(bodies.size());
    std::ranges::transform(bodies, distances.begin(), [&](const PlacedBox& body) { return farthest(body, eye); });
    std::vector<std::size_t> order(bodies.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return distances[i]; });
    return order;
}

}  // namespace tactooth
