// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/stl_writer.h"

#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

#include "geometry/files/atomic_file.h"
#include "geometry/io/stl_format.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

/// Does not begin with `solid`, so that a simple reader does not take it for text.
constexpr std::string_view kBinaryHeader = "Tactooth binary STL, millimetres";

Vec3f normalOf(const TriangleMesh& mesh, std::size_t triangle) {
    return mesh.areaVector(triangle).stableNormalized().cast<float>();
}

std::vector<std::byte> binaryBytes(const TriangleMesh& mesh) {
    TACTOOTH_ASSERT(mesh.triangles.size() <= std::numeric_limits<std::uint32_t>::max());
    std::vector<std::byte> bytes(stl::kFirstRecord + mesh.triangles.size() * stl::kRecordBytes);
    std::memcpy(bytes.data(), kBinaryHeader.data(), kBinaryHeader.size());
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    std::memcpy(bytes.data() + stl::kHeaderBytes, &count, sizeof count);
    std::byte* record = bytes.data() + stl::kFirstRecord;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle, record += stl::kRecordBytes) {
        const auto& [a, b, c] = mesh.triangles[triangle];
        std::byte* number = record;
        for (const Vec3f& vector : {normalOf(mesh, triangle), mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}) {
            std::memcpy(number, vector.data(), stl::kVectorBytes);
            number += stl::kVectorBytes;
        }
    }
    return bytes;
}

/// Appends text to a growing byte array.
class AsciiWriter {
public:
    void text(std::string_view words) {
        const auto* begin = reinterpret_cast<const std::byte*>(words.data());
        bytes_.insert(bytes_.end(), begin, begin + words.size());
    }
    /// Three numbers, each in the shortest form that reads back as the same float.
    void numbers(const Vec3f& vector) {
        for (const float number : vector) {
            std::array<char, 32> digits;
            digits[0] = ' ';
            const auto end = std::to_chars(digits.data() + 1, digits.data() + digits.size(), number).ptr;
            text({digits.data(), static_cast<std::size_t>(end - digits.data())});
        }
        text("\n");
    }
    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
};

std::vector<std::byte> asciiBytes(const TriangleMesh& mesh) {
    AsciiWriter out;
    out.text("solid tactooth\n");
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        out.text("facet normal");
        out.numbers(normalOf(mesh, triangle));
        out.text("outer loop\n");
        for (const std::uint32_t vertex : mesh.triangles[triangle]) {
            out.text("vertex");
            out.numbers(mesh.vertices[vertex]);
        }
        out.text("endloop\nendfacet\n");
    }
    out.text("endsolid tactooth\n");
    return out.take();
}

}  // namespace

std::vector<std::byte> stlBytes(const TriangleMesh& mesh, StlFormat format) {
    return format == StlFormat::Binary ? binaryBytes(mesh) : asciiBytes(mesh);
}

Expected<void> writeStl(const TriangleMesh& mesh, const std::filesystem::path& path, StlFormat format) {
    return writeFile(path, stlBytes(mesh, format));
}

}  // namespace tactooth
