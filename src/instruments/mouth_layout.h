// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "instruments/builtin_mouth.h"

namespace tactooth {

/// The poses of the teeth and both gingivae of a mouth. Mouth frame, mouth closed. They depend on `triangles`, `seed`
/// and `missing` of a request, and not on the pose of the jaw.
struct MouthLayout {
    static constexpr std::size_t kPlaces = 16;
    /// Poses of the teeth 11 to 18 and 31 to 38; those of the other side are their mirror images.
    std::array<Pose, kPlaces> toothInMouth;
    TriangleMesh upperGingiva, lowerGingiva;
    ZonedMesh upperShown, lowerShown;
};

/// FDI number of an index of the layout.
[[nodiscard]] constexpr int fdiOfPlace(std::size_t place) { return (place < 8 ? 11 : 23) + static_cast<int>(place); }

/// Fails with a sentence if a gingiva intersects itself at every resolution that is tried.
[[nodiscard]] Expected<MouthLayout> makeMouthLayout(const MouthRequest& request);

/// A hash of the result of makeMouthLayout: it changes with the request, the anatomy of a tooth and the methods of
/// placing and meshing. Quick.
[[nodiscard]] std::uint64_t mouthLayoutFingerprint(const MouthRequest& request);

/// Makes a layout: makeMouthLayout, or a function with a cache.
using LayoutGenerator = std::function<Expected<MouthLayout>(const MouthRequest&)>;

/// Like makeMouth in builtin_mouth.h. Both functions are called from several threads at once.
[[nodiscard]] Expected<BuiltinMouth> makeMouth(const MouthRequest& request, const ToothGenerator& teeth,
                                               const LayoutGenerator& layout);

}  // namespace tactooth
