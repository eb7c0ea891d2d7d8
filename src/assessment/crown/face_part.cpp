// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/crown/face_part.h"

namespace tactooth {

TriangleMesh partAbove(const TriangleMesh& mesh, std::span<const double> values) {
    TACTOOTH_ASSERT(values.size() == mesh.vertices.size());
    TriangleMesh part{mesh.vertices, {}};
    // The place of the edge from a vertex to another where the value is 0.
    const auto end = [&](std::uint32_t from, std::uint32_t to) {
        const auto share = static_cast<float>(values[from] / (values[from] - values[to]));
        part.vertices.emplace_back(mesh.vertices[from] + share * (mesh.vertices[to] - mesh.vertices[from]));
        return static_cast<std::uint32_t>(part.vertices.size() - 1);
    };
    for (const Triangle& triangle : mesh.triangles) {
        std::array<std::uint32_t, 4> corners{};
        std::size_t count = 0;
        for (std::size_t i = 0; i < triangle.size(); ++i) {
            const std::uint32_t from = triangle.at(i), to = triangle.at((i + 1) % triangle.size());
            if (values[from] > 0) corners.at(count++) = from;
            if ((values[from] > 0) != (values[to] > 0)) corners.at(count++) = end(from, to);
        }
        for (std::size_t i = 2; i < count; ++i)
            part.triangles.push_back({corners[0], corners.at(i - 1), corners.at(i)});
    }
    return part;
}

}  // namespace tactooth
