// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/stl_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

#include "geometry/files/file_bytes.h"
#include "geometry/io/stl_format.h"
#include "geometry/io/stl_sniffer.h"
#include "geometry/mesh/vertex_welder.h"
#include "geometry/util/byte_text.h"
#include "geometry/util/messages.h"

namespace tactooth {

static_assert(std::endian::native == std::endian::little,
              "binary STL is little-endian and is read as it lies in memory");

namespace {

static_assert(sizeof(Vec3f) == stl::kVectorBytes);

/// The corners of some triangles, read from their records. Eight such blocks fit into the first-level cache.
class CornerBlock {
public:
    static constexpr std::size_t kTriangles = 16;

    CornerBlock(std::span<const std::byte> records, std::size_t first, std::size_t count)
        : size_(std::min(kTriangles, count - first)) {
        for (std::size_t i = 0; i < size_; ++i) {
            const std::size_t offset = (first + i) * stl::kRecordBytes + stl::kVectorBytes;
            std::memcpy(corners_[3 * i].data(), records.data() + offset, 3 * stl::kVectorBytes);
        }
    }

    [[nodiscard]] std::span<const Vec3f> corners() const { return std::span(corners_).first(3 * size_); }

    /// The first triangle with a corner that is not finite, or kTriangles.
    [[nodiscard]] std::size_t notFinite() const {
        bool allFinite = true;  // the usual case without a branch for each number
        for (const Vec3f& corner : corners()) allFinite &= corner.allFinite();
        if (allFinite) return kTriangles;
        const auto bad = std::ranges::find_if(corners(), [](const Vec3f& corner) { return !corner.allFinite(); });
        return static_cast<std::size_t>(bad - corners().begin()) / 3;
    }

private:
    std::size_t size_;
    std::array<Vec3f, 3 * kTriangles> corners_;
};

}  // namespace

Expected<TriangleMesh> stl::parseBinary(std::span<const std::byte> bytes, const std::string& name) {
    const std::size_t count = (bytes.size() - kFirstRecord) / kRecordBytes;
    if (count == 0) return unexpected(msg::kNoTriangles, name);
    VertexWelder welder(count / 2 + 2);  // a closed surface has half as many vertices as triangles
    TriangleMesh mesh;
    mesh.triangles.resize(count);
    for (std::size_t first = 0; first < count; first += CornerBlock::kTriangles) {
        const CornerBlock block(bytes.subspan(kFirstRecord), first, count);
        if (const std::size_t bad = block.notFinite(); bad != CornerBlock::kTriangles) {
            const std::size_t offset = kFirstRecord + (first + bad) * kRecordBytes + kVectorBytes;
            return unexpected(msg::kStlCornerNotFinite, name, first + bad + 1, offset);
        }
        welder.addAll(block.corners(), mesh.triangles[first].data());
    }
    mesh.vertices = welder.takeVertices();
    return mesh;
}

Expected<TriangleMesh> parseStl(std::span<const std::byte> bytes, std::string_view name) {
    const std::string shown(name);
    switch (stl::sniff(bytes)) {
        case stl::Kind::Binary:
            return stl::parseBinary(bytes, shown);
        case stl::Kind::Ascii: {
            auto read = stl::parseAsciiInPlace(asText(bytes), shown);
            if (!read) return Unexpected{read.error()};
            return std::move(read->mesh);
        }
        case stl::Kind::Neither:
            break;
    }
    return Unexpected{stl::explainRefusal(bytes, shown)};
}

Expected<TriangleMesh> readStl(const std::filesystem::path& path) {
    const Expected<FileBytes> file = readFile(path);
    if (!file) return Unexpected{file.error()};
    return parseStl(file->bytes(), displayName(path));
}

}  // namespace tactooth
