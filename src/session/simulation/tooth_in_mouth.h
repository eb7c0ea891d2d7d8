// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "instruments/builtin_mouth.h"
#include "session/simulation/cut_model.h"
#include "session/simulation/tooth_cache.h"

namespace tactooth {

/// A soft tissue that is drawn, and not touched.
struct SoftTissueBody {
    SoftTissueKind kind;
    std::shared_ptr<const Surface> surface;
    std::shared_ptr<const std::vector<std::uint8_t>> zones;  ///< ZonedMesh::zones
};
/// Those of an open mouth; `mouthInFrame`: into the frame of the result. `worked`: as for softTissuesOf.
[[nodiscard]] std::vector<SoftTissueBody> softTissueBodies(const BuiltinMouth& mouth, int worked,
                                                           const Pose& mouthInFrame);

/// A tooth to work on, and the mouth around it.
struct ToothInMouth {
    BuiltinTooth tooth;
    std::vector<BuiltinTooth> beside = {};  ///< the teeth next to it, in its frame; they can be cut as well
    struct Body {
        std::shared_ptr<const SurfacePart> part;    ///< in the frame of `tooth`, tagged by MaterialId
        std::shared_ptr<const TriangleMesh> shown;  ///< the visible part
        bool isGingiva = false;
        bool isOpposite = false;                                      ///< in the other jaw
        std::shared_ptr<const std::vector<std::uint8_t>> zones = {};  ///< of a gingiva: ZonedMesh::zones; else null
        bool isBeyond = false;  ///< a tooth of the same jaw, on the other side of the midline
        /// Of the gingiva of the same jaw.
        struct Half {
            Vec3 toOwnSide = Vec3::UnitX();  ///< unit, across the midline to the side of `tooth`, in its frame
            std::shared_ptr<const TriangleMesh> shown;
            std::shared_ptr<const std::vector<std::uint8_t>> zones;
        };
        std::optional<Half> ownHalf = {};  ///< on the side of `tooth`
        int fdi = 0;                       ///< of a tooth
        Pose bodyInTooth = {};             ///< from its own frame to that of `tooth`
        Box3 ownBox = {};                  ///< in its own frame
    };
    std::vector<Body> around = {};                 ///< all other bodies
    std::vector<SoftTissueBody> softTissues = {};  ///< of an open mouth, in the frame of `tooth`
};

/// `fdi` is a tooth of the mouth that is not missing; its resolution and seed are those of the mouth. Takes as long as
/// makeMouth, and fails where makeMouth does.
[[nodiscard]] Expected<ToothInMouth> toothInMouth(int fdi, const std::optional<Lesion>& lesion,
                                                  const MouthRequest& mouth,
                                                  const ToothGenerator& generator = makeTooth);

/// The same with teeth and gums from the cache; takes a second. `partDone`: see ToothCache::makeMouth.
[[nodiscard]] Expected<ToothInMouth> toothInMouth(int fdi, const std::optional<Lesion>& lesion,
                                                  const MouthRequest& mouth, const ToothCache& cache,
                                                  const std::function<void(double)>& partDone = {});

/// The part of a tooth that may be visible above the gum, for drawing; open at its end.
[[nodiscard]] TriangleMesh supragingivalMesh(const TriangleMesh& tooth);

[[nodiscard]] Surroundings surroundingsOf(const ToothInMouth& tooth);

/// The tooth with those beside it, to be cut.
[[nodiscard]] Expected<LayeredTooth> layeredTooth(const ToothInMouth& tooth);

}  // namespace tactooth
