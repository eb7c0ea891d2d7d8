// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of cases refuses them with a sentence, or gives a tooth whose surfaces are valid. The
// bytes are tried as an archive, and as the description in an archive that is sound.
#include <cstdlib>

#include "fuzz/fuzz_target.h"
#include "geometry/stl_writer.h"
#include "session/cases/open_case.h"

namespace {

using namespace tactooth;

void require(bool holds) {
    if (!holds) std::abort();
}

void tryToOpen(std::span<const std::byte> bytes) {
    const auto store = CaseStore::openArchive(bytes, "fuzz");
    const auto opened = store ? openCase(*store) : Expected<OpenedCase>(Unexpected{store.error()});
    if (!opened) {
        const std::string& sentence = opened.error().message;
        require(sentence.starts_with("fuzz") && sentence.ends_with('.') && sentence.size() < 1000);
        require(sentence.find('\n') == std::string::npos);
        return;
    }
    const TriangleMesh& mesh = opened->teeth->outer()->mesh();
    for (const Vec3f& vertex : mesh.vertices) require(vertex.allFinite());
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) require(vertex < mesh.vertices.size());
    }
    // What can be read can be written and read again.
    require(parseCase(caseText(opened->description), "fuzz").has_value());
}

/// A tetrahedron, so that a description has a surface to name.
std::vector<std::byte> smallSurface() {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    return stlBytes(mesh);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span<const std::byte> raw = std::as_bytes(std::span(data, size));
    tryToOpen(raw);
    const auto packed = packedCase({{"case.toml", {raw.begin(), raw.end()}}, {"a.stl", smallSurface()}});
    require(packed.has_value());
    tryToOpen(*packed);
    return 0;
}
