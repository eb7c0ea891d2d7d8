// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of saved teeth refuses them with a sentence, or gives surfaces and fields that are
// valid. Also with the checksum put right, which no chance would: what lies behind it must not rely on it.
#include <cmath>
#include <cstring>

#include "fuzz/fuzz_target.h"
#include "geometry/util/byte_stream.h"
#include "tooth/file/saved_tooth.h"

namespace tactooth::test {
namespace {

void requireValidTooth(const SavedTooth& tooth) {
    requireValid(tooth.outer);
    for (const LayerMesh& layer : tooth.layers) requireValid(layer.mesh);
    for (const double removed : tooth.removed) require(removed >= 0 && std::isfinite(removed), "volumes are finite");
    require(tooth.voxel > 0, "voxels have a size");
    for (const auto& [key, field] : tooth.cuts) {
        for (const float cut : field.cut) {
            require(std::abs(cut) <= static_cast<float>(kCutBand * tooth.voxel), "distances stay in their band");
        }
        for (const auto& crossings : field.boundary) {
            for (const HermiteSample& crossing : crossings)
                require(crossing.place >= 0 && crossing.place <= 1, "borders lie between two nodes");
        }
    }
}

bool isRead(std::span<const std::byte> bytes) {
    const Expected<SavedTooth> tooth = parseSavedTooth(bytes, "fuzz");
    if (!tooth) return requireSentence(tooth.error()), false;
    requireValidTooth(*tooth);
    return true;
}

bool accepts(std::span<const std::byte> bytes) {
    const bool isReadAsItIs = isRead(bytes);
    std::vector<std::byte> sealed(bytes.begin(), bytes.end());
    if (sealed.size() < sizeof(std::uint64_t)) return isReadAsItIs;
    const std::size_t end = sealed.size() - sizeof(std::uint64_t);
    const std::uint64_t sum = checksum(std::span(sealed).first(end));
    std::memcpy(sealed.data() + end, &sum, sizeof sum);
    return isRead(sealed) || isReadAsItIs;
}

const AddFuzzTarget added({"tooth", accepts});

}  // namespace
}  // namespace tactooth::test
