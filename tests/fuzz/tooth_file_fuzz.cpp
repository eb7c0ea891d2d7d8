// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of saved teeth refuses them with a sentence, or gives surfaces and fields that are
// valid. Also with the checksum put right, which no chance would: what lies behind it must not rely on it.
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "fuzz/fuzz_target.h"
#include "tooth/byte_stream.h"
#include "tooth/saved_tooth.h"

namespace {

using namespace tactooth;

void require(bool holds) {
    if (!holds) std::abort();
}

void requireValid(const TriangleMesh& mesh) {
    for (const Vec3f& vertex : mesh.vertices) require(vertex.allFinite());
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) require(vertex < mesh.vertices.size());
    }
}

void requireValid(const SavedTooth& tooth) {
    requireValid(tooth.outer);
    for (const LayerMesh& layer : tooth.layers) requireValid(layer.mesh);
    for (const double removed : tooth.removed) require(removed >= 0 && std::isfinite(removed));
    require(tooth.voxel > 0);
    for (const auto& [key, field] : tooth.cuts) {
        for (const float cut : field.cut) require(std::abs(cut) <= static_cast<float>(kCutBand * tooth.voxel));
        for (const auto& places : field.borderPlace) {
            for (const float place : places) require(place >= 0 && place <= 1);
        }
    }
}

void tryToRead(std::span<const std::byte> bytes) {
    const Expected<SavedTooth> tooth = parseSavedTooth(bytes, "fuzz");
    if (tooth) return requireValid(*tooth);
    const std::string& sentence = tooth.error().message;
    require(sentence.starts_with("fuzz") && sentence.ends_with('.') && sentence.size() < 400);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span<const std::byte> raw = std::as_bytes(std::span(data, size));
    tryToRead(raw);
    std::vector<std::byte> sealed(raw.begin(), raw.end());
    if (sealed.size() < sizeof(std::uint64_t)) return 0;
    const std::size_t end = sealed.size() - sizeof(std::uint64_t);
    const std::uint64_t sum = checksum(std::span(sealed).first(end));
    std::memcpy(sealed.data() + end, &sum, sizeof sum);
    tryToRead(sealed);
    return 0;
}
