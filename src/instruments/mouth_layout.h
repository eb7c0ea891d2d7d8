// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "instruments/builtin_mouth.h"

namespace tactooth {

/// What a mouth has beside the teeth themselves. Mouth frame, mouth closed. `triangles`, `seed` and `missing` of a
/// request decide about it; the pose of the jaw does not.
struct MouthLayout {
    static constexpr std::size_t kPlaces = 16;
    /// Where the teeth 11 to 18 and 31 to 38 stand; those of the other side stand as their mirror images.
    std::array<Pose, kPlaces> toothInMouth;
    TriangleMesh upperGingiva, lowerGingiva;
};

/// FDI number of a place of a setting.
[[nodiscard]] constexpr int fdiOfPlace(std::size_t place) { return (place < 8 ? 11 : 23) + static_cast<int>(place); }

/// Fails with a sentence if a gum crosses itself at every fineness that is tried.
[[nodiscard]] Expected<MouthLayout> makeMouthLayout(const MouthRequest& request);

/// A number for what makeMouthLayout would make: another one where the request, the anatomy of a tooth or the way of
/// setting and meshing is another. Quick.
[[nodiscard]] std::uint64_t mouthLayoutFingerprint(const MouthRequest& request);

/// Makes a setting: makeMouthLayout, or one that remembers.
using LayoutGenerator = std::function<Expected<MouthLayout>(const MouthRequest&)>;

/// As makeMouth in builtin_mouth.h. Both makers are called from several threads at once.
[[nodiscard]] Expected<BuiltinMouth> makeMouth(const MouthRequest& request, const ToothGenerator& teeth,
                                               const LayoutGenerator& layout);

}  // namespace tactooth
