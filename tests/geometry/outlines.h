// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Core>

namespace tactooth::test {

using Outline = std::vector<Vec2>;
using Random = std::mt19937;

inline double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Corners around the middle at random distances: simple, and hardly ever convex.
inline Outline star(Random& random) {
    Outline outline;
    const int corners = std::uniform_int_distribution<int>(4, 40)(random);
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * (i + uniform(random, 0.1, 0.9)) / corners;
        outline.emplace_back(Vec2(std::cos(angle), std::sin(angle)) * uniform(random, 0.5, 6));
    }
    return outline;
}

/// Teeth on a bar, like a letter E, also with corners on straight edges.
inline Outline comb(Random& random) {
    const int teeth = std::uniform_int_distribution<int>(2, 9)(random);
    Outline outline = {{0, 0}, {2.0 * teeth - 1, 0}};
    for (int i = teeth - 1; i >= 0; --i) {
        const double height = uniform(random, 2, 5);
        outline.insert(outline.end(), {{2.0 * i + 1, height}, {2.0 * i + 0.5, height}, {2.0 * i, height}});
        if (i > 0) outline.insert(outline.end(), {{2.0 * i, 1}, {2.0 * i - 0.5, 1}, {2.0 * i - 1, 1}});
    }
    return outline;
}

inline Outline spiral(Random& random) {
    Outline inner, outer;
    const int corners = std::uniform_int_distribution<int>(20, 60)(random);
    for (int i = 0; i < corners; ++i) {
        const double angle = 0.4 * i, radius = 1 + 0.3 * angle;
        const Vec2 way(std::cos(angle), std::sin(angle));
        inner.emplace_back(way * radius);
        outer.emplace_back(way * (radius + 0.8));
    }
    outer.insert(outer.end(), inner.rbegin(), inner.rend());
    return outer;
}

/// A square with square holes in a row, each connected by two coincident edges.
inline Outline keyholes(Random& random) {
    const int holes = std::uniform_int_distribution<int>(1, 4)(random);
    Outline outline = {{0, 0}};
    for (int i = 0; i < holes; ++i) {
        const double x = 3.0 * i + uniform(random, 0.5, 1.5);
        const Outline hole = {{x, 1}, {x, 2}, {x + 1, 2}, {x + 1, 1}, {x, 1}};
        outline.emplace_back(x, 0);
        outline.insert(outline.end(), hole.begin(), hole.end());
        outline.emplace_back(x, 0);
    }
    outline.insert(outline.end(), {{3.0 * holes, 0}, {3.0 * holes, 3}, {0, 3}});
    return outline;
}

/// A star with more corners on every edge, and with duplicate corners.
inline Outline dividedStar(Random& random) {
    const Outline corners = star(random);
    Outline outline;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2& next = corners[(i + 1) % corners.size()];
        outline.push_back(corners[i]);
        if (uniform(random, 0, 1) < 0.3) outline.push_back(corners[i]);
        for (const double share : {0.25, 0.5}) outline.emplace_back(corners[i] + share * (next - corners[i]));
    }
    return outline;
}

struct Shape {
    const char* name;
    Outline (*make)(Random&);
};
inline const Shape kShapes[] = {
    {"star", star}, {"comb", comb}, {"spiral", spiral}, {"keyholes", keyholes}, {"divided star", dividedStar}};

}  // namespace tactooth::test
