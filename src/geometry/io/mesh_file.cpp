// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/mesh_file.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "geometry/files/file_bytes.h"
#include "geometry/io/mesh_bytes.h"
#include "geometry/io/obj_reader.h"
#include "geometry/io/ply_header.h"
#include "geometry/io/ply_reader.h"
#include "geometry/io/stl_format.h"
#include "geometry/io/stl_reader.h"
#include "geometry/io/stl_sniffer.h"
#include "geometry/util/byte_text.h"
#include "geometry/util/lower_case.h"
#include "geometry/util/messages.h"

namespace tactooth {
namespace {

/// Mesh and volume formats that a dental scanner or its program may write.
bool isOtherFormat(std::string_view extension) {
    static constexpr std::array<std::string_view, 9> kOthers = {".off",  ".3mf", ".glb", ".gltf", ".dcm",
                                                                ".step", ".stp", ".amf", ".nii"};
    return std::find(kOthers.begin(), kOthers.end(), extension) != kOthers.end();
}

Expected<ReadMesh> parseAnyStl(std::span<const std::byte> bytes, const std::filesystem::path& path) {
    if (stl::sniff(bytes) == stl::Kind::Ascii) return stl::parseAscii(asText(bytes), displayName(path));
    Expected<TriangleMesh> mesh = parseStl(bytes, displayName(path));
    if (!mesh) return Unexpected{mesh.error()};
    return ReadMesh{std::move(*mesh)};
}

/// The surface, if it was not shifted.
Expected<TriangleMesh> inPlace(Expected<ReadMesh> read, const std::filesystem::path& path,
                               std::vector<ImportNote>* importNotes) {
    if (!read) return Unexpected{read.error()};
    if (!read->offset.isZero(0)) {
        return unexpected(msg::kSurfaceTooFar, displayName(path));
    }
    if (importNotes != nullptr)
        importNotes->insert(importNotes->end(), read->importNotes.begin(), read->importNotes.end());
    return std::move(read->mesh);
}

}  // namespace

Expected<ReadMesh> parseReadMesh(std::span<const std::byte> bytes, const std::filesystem::path& path) {
    const std::string extension = toLowerCase(path.extension().string());
    if (ply::looksLikePly(asText(bytes))) return parsePly(bytes, displayName(path));
    if (stl::sniff(bytes) == stl::Kind::Neither) {
        if (isWideText(asText(bytes))) return unexpected(msg::kTextInUtf16, displayName(path));
        if (extension == ".obj") return parseObj(bytes, displayName(path));
        if (isOtherFormat(extension)) {
            return unexpected(msg::kFormatNotRead, displayName(path), extension);
        }
    }
    return parseAnyStl(bytes, path);
}

Expected<ReadMesh> readMesh(const std::filesystem::path& path) {
    const Expected<FileBytes> file = readFile(path);
    if (!file) return Unexpected{file.error()};
    Expected<ReadMesh> read = parseReadMesh(file->bytes(), path);
    if (!read) return read;
    // An import note may be stored with the surface, where the user's folders are private.
    for (ImportNote& importNote : read->importNotes) importNote.message.replaceFirst(displayName(path.filename()));
    return read;
}

Expected<TriangleMesh> parseMesh(std::span<const std::byte> bytes, const std::filesystem::path& path,
                                 std::vector<ImportNote>* importNotes) {
    return inPlace(parseReadMesh(bytes, path), path, importNotes);
}

Expected<TriangleMesh> loadMesh(const std::filesystem::path& path, std::vector<ImportNote>* importNotes) {
    return inPlace(readMesh(path), path, importNotes);
}

}  // namespace tactooth
