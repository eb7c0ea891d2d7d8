// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_file.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "geometry/byte_text.h"
#include "geometry/file_bytes.h"
#include "geometry/mesh_bytes.h"
#include "geometry/obj_reader.h"
#include "geometry/ply_header.h"
#include "geometry/ply_reader.h"
#include "geometry/small_letters.h"
#include "geometry/stl_reader.h"
#include "geometry/stl_sniffer.h"

namespace tactooth {
namespace {

/// Mesh and volume formats that a dental scanner or its program may write.
bool isOtherFormat(std::string_view extension) {
    static constexpr std::array<std::string_view, 9> kOthers = {".off",  ".3mf", ".glb", ".gltf", ".dcm",
                                                                ".step", ".stp", ".amf", ".nii"};
    return std::find(kOthers.begin(), kOthers.end(), extension) != kOthers.end();
}

}  // namespace

Expected<TriangleMesh> parseMesh(std::span<const std::byte> bytes, const std::filesystem::path& path) {
    const std::string extension = inSmallLetters(path.extension().string());
    if (ply::looksLikePly(asText(bytes))) return parsePly(bytes, shownName(path));
    if (stl::sniff(bytes) == stl::Kind::Neither) {
        if (extension == ".obj") return parseObj(bytes, shownName(path));
        if (isOtherFormat(extension)) {
            return unexpected(shownName(path) + ": " + extension +
                              " files cannot be read; export the surface as STL, OBJ or PLY.");
        }
    }
    return parseStl(bytes, shownName(path));
}

Expected<TriangleMesh> loadMesh(const std::filesystem::path& path) {
    const Expected<FileBytes> file = readFile(path);
    if (!file) return Unexpected{file.error()};
    return parseMesh(file->bytes(), path);
}

}  // namespace tactooth
