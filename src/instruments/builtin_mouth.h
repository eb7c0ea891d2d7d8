// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/util/expected.h"
#include "geometry/util/pose.h"
#include "instruments/builtin_tooth.h"
#include "instruments/mouth/soft_tissues.h"
#include "instruments/mouth/zoned_mesh.h"

namespace tactooth {

enum class JawPose {
    Closed,  ///< the teeth are in occlusion
    Open,    ///< as wide as for treatment: 40 mm between the edges of the incisors
};

struct MouthRequest {
    int triangles = 20000;   ///< of each tooth's outer surface, about; the gingiva has a matching resolution
    std::uint32_t seed = 0;  ///< 0: average teeth; any other number: another patient
    JawPose jaw = JawPose::Closed;
    std::vector<int> missing;  ///< FDI numbers; the gingiva has healed there
};

/// One tooth of a mouth.
struct MouthTooth {
    BuiltinTooth tooth;
    Pose toothInMouth;  ///< with the mouth closed
};

/// A whole mouth. Mouth frame: that of the upper jaw; +x to the patient's right, +y forward, +z up; origin between the
/// edges of the lower central incisors when the mouth is closed; mm. The two sides are mirror images.
struct BuiltinMouth {
    std::vector<MouthTooth> teeth;  ///< 18 to 11, 21 to 28, 38 to 31, 41 to 48; missing ones left out
    TriangleMesh upperGingiva;      ///< with palate and ridge, closed, with a socket for each tooth; mouth frame
    TriangleMesh lowerGingiva;      ///< likewise; mouth frame, with the mouth closed
    /// The same two as they are drawn, in the frames of theirs: the margin lies on the enamel. Not closed where a tooth
    /// stands. Zones: free margin, attached keratinised gingiva, alveolar mucosa.
    ZonedMesh upperShown, lowerShown;
    JawPose jaw = JawPose::Closed;
    std::vector<Pose> sideInMouth;  ///< poses of the teeth 11 to 18 and 31 to 38, of missing ones too; mouth closed
    Pose lowerJaw;                  ///< maps the lower jaw from its closed position to the present one

    /// Pose of a tooth for the requested jaw pose.
    [[nodiscard]] Pose poseOf(const MouthTooth& tooth) const {
        return tooth.tooth.fdi < 30 ? tooth.toothInMouth : lowerJaw * tooth.toothInMouth;
    }
    /// The tooth with this number; null if it is missing.
    [[nodiscard]] const MouthTooth* find(int fdi) const;
};

/// Makes a tooth: makeTooth, or a function with a cache.
using ToothGenerator = std::function<BuiltinTooth(const ToothRequest&)>;

/// Makes a mouth. The same request gives the same bits, on any number of threads. `generator` is called from several
/// threads at once. Fails with a sentence if no valid gingiva can be made.
[[nodiscard]] Expected<BuiltinMouth> makeMouth(const MouthRequest& request,
                                               const ToothGenerator& generator = makeTooth);

/// What surrounds the jaws of an open mouth; nothing if it is closed. Mouth frame. `worked`: FDI number of the tooth
/// that is worked on, where the tongue is held aside; 0: none. Takes a tenth of a second.
[[nodiscard]] std::vector<SoftTissue> softTissuesOf(const BuiltinMouth& mouth, int worked = 0);

/// The pose of the lower jaw in the mouth frame, relative to its closed position.
[[nodiscard]] Pose lowerJawPose(JawPose jaw);

}  // namespace tactooth
