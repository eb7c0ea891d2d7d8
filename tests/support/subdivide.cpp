// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "support/subdivide.h"

#include <algorithm>
#include <map>
#include <utility>

namespace tactooth::test {

TriangleMesh subdivided(const TriangleMesh& mesh) {
    TriangleMesh finer{mesh.vertices, {}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [found, isNew] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(finer.vertices.size()));
        if (isNew) {
            const Vec3 sum = mesh.vertices[a].cast<double>() + mesh.vertices[b].cast<double>();
            finer.vertices.push_back((sum / 2).cast<float>());
        }
        return found->second;
    };
    for (const Triangle& t : mesh.triangles) {
        const Triangle inner = {middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
        finer.triangles.insert(
            finer.triangles.end(),
            {{t[0], inner[0], inner[2]}, {inner[0], t[1], inner[1]}, {inner[2], inner[1], t[2]}, inner});
    }
    return finer;
}

}  // namespace tactooth::test
