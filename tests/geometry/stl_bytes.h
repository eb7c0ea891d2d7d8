// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth::test {

/// A binary STL that is made independently of the program's writer, so that each field can be wrong.
inline std::string binaryStl(std::string header, std::uint32_t announced,
                             const std::vector<std::array<float, 9>>& triangles) {
    header.resize(80, ' ');
    std::string bytes = header;
    bytes.append(reinterpret_cast<const char*>(&announced), sizeof announced);
    for (const std::array<float, 9>& corners : triangles) {
        bytes.append(12, '\0');  // normal
        bytes.append(reinterpret_cast<const char*>(corners.data()), sizeof corners);
        bytes.append(2, '\0');  // attribute
    }
    return bytes;
}

/// The corners of a tetrahedron at the origin with edges of 1 mm along the axes, outside counter-clockwise.
inline const std::vector<std::array<float, 9>> kTetrahedron = {{{0, 0, 0, 0, 1, 0, 1, 0, 0}},
                                                               {{0, 0, 0, 1, 0, 0, 0, 0, 1}},
                                                               {{0, 0, 0, 0, 0, 1, 0, 1, 0}},
                                                               {{1, 0, 0, 0, 1, 0, 0, 0, 1}}};

/// Every coordinate of every triangle in order: what writing and reading must preserve.
inline std::vector<std::uint32_t> coordinateBits(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> bits;
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            std::array<std::uint32_t, 3> numbers;
            std::memcpy(numbers.data(), mesh.vertices[vertex].data(), sizeof numbers);
            bits.insert(bits.end(), numbers.begin(), numbers.end());
        }
    }
    return bits;
}

}  // namespace tactooth::test
