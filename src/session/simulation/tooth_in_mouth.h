// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "instruments/builtin_mouth.h"
#include "session/simulation/cut_model.h"
#include "session/simulation/tooth_cache.h"

namespace tactooth {

/// A tooth that is to be worked on, and all of the mouth around it.
struct ToothInMouth {
    BuiltinTooth tooth;
    std::vector<BuiltinTooth> beside = {};  ///< those next to it, in its frame: a bur that slips cuts them as well
    struct Body {
        std::shared_ptr<const SurfacePart> part;    ///< in the frame of `tooth`, tagged by MaterialId
        std::shared_ptr<const TriangleMesh> shown;  ///< what of it can be seen
        bool isGingiva = false;
        bool isOpposite = false;  ///< of the other jaw
    };
    std::vector<Body> around = {};  ///< all others
};

/// `tooth.fdi` is a tooth of the mouth that is not missing; its fineness and seed are the mouth's. Takes the time that
/// a mouth takes, and fails where makeMouth does.
[[nodiscard]] Expected<ToothInMouth> toothInMouth(int fdi, const std::optional<Lesion>& lesion,
                                                  const MouthRequest& mouth, const ToothGenerator& maker = makeTooth);

/// The same, with teeth and gums that were made before: a matter of a second.
[[nodiscard]] Expected<ToothInMouth> toothInMouth(int fdi, const std::optional<Lesion>& lesion,
                                                  const MouthRequest& mouth, const ToothCache& cache);

/// A tooth without what is sure to lie below the gum, to be drawn: open at its end.
[[nodiscard]] TriangleMesh supragingivalMesh(const TriangleMesh& tooth);

[[nodiscard]] Surroundings surroundingsOf(const ToothInMouth& tooth);

/// The tooth as it is cut, with those beside it.
[[nodiscard]] Expected<LayeredTooth> layeredTooth(const ToothInMouth& tooth);

}  // namespace tactooth
