// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/stl_reader.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "geometry/file_bytes.h"
#include "geometry/stl_format.h"
#include "geometry/stl_sniffer.h"
#include "geometry/vertex_welder.h"

namespace tactooth {

static_assert(std::endian::native == std::endian::little,
              "binary STL is little-endian and is read as it lies in memory");

Expected<TriangleMesh> stl::parseBinary(std::span<const std::byte> bytes, const std::string& name) {
    const std::size_t count = (bytes.size() - kFirstRecord) / kRecordBytes;
    if (count == 0) return unexpected(name + ": the file holds no triangles; export the surface again.");
    VertexWelder welder(count / 2 + 2);  // a closed surface has half as many vertices as triangles
    TriangleMesh mesh;
    mesh.triangles.resize(count);
    for (std::size_t triangle = 0; triangle < count; ++triangle) {
        const std::size_t offset = kFirstRecord + triangle * kRecordBytes + kVectorBytes;
        std::array<float, 9> numbers;
        std::memcpy(numbers.data(), bytes.data() + offset, sizeof numbers);
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3f position(numbers[3 * corner], numbers[3 * corner + 1], numbers[3 * corner + 2]);
            if (!position.allFinite()) {
                return unexpected(name + ": triangle " + std::to_string(triangle + 1) + " (byte " +
                                  std::to_string(offset) +
                                  ") has a corner that is not a finite number; repair or export the surface again.");
            }
            mesh.triangles[triangle][corner] = welder.add(position);
        }
    }
    mesh.vertices = welder.takeVertices();
    return mesh;
}

Expected<TriangleMesh> parseStl(std::span<const std::byte> bytes, std::string_view name) {
    const std::string shown(name);
    switch (stl::sniff(bytes)) {
        case stl::Kind::Binary:
            return stl::parseBinary(bytes, shown);
        case stl::Kind::Ascii:
            return stl::parseAscii({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, shown);
        case stl::Kind::Neither:
            break;
    }
    return Unexpected{stl::explainRefusal(bytes, shown)};
}

Expected<TriangleMesh> readStl(const std::filesystem::path& path) {
    const Expected<FileBytes> file = readFile(path);
    if (!file) return Unexpected{file.error()};
    return parseStl(file->bytes(), shownName(path));
}

}  // namespace tactooth
