// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/tissue_volumes.h"

#include "assessment/messages.h"

namespace tactooth {
namespace {

TriangleMesh decayOf(const LayeredTooth& tooth) {
    TriangleMesh decay;
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        if (tooth.materials().hasRole(layer.material, MaterialRole::Decay)) append(decay, layer.part->mesh());
    }
    return decay;
}

}  // namespace

TissueVolumes tissueVolumes(const Preparation& preparation, const PreparedVolumes& volumes, double spacing) {
    TissueVolumes result;
    if (preparation.tooth == nullptr || preparation.tooth->layers().empty()) {
        for (Measured* each : {&result.removedEnamel, &result.removedDentin, &result.removedPulp, &result.removedDecay,
                               &result.decayLeft, &result.decayShare, &result.overEnamel, &result.overDentin,
                               &result.underEnamel, &result.underDentin}) {
            *each = Measured::none(msg::kNoTissueKnown);
        }
        return result;
    }
    const auto of = [](const PreparedVolumes& all, MaterialRole role) {
        return all.tissues[static_cast<std::size_t>(role)];
    };
    result.removedEnamel = Measured::of(of(volumes, MaterialRole::Enamel).removed);
    result.removedDentin = Measured::of(of(volumes, MaterialRole::Dentin).removed);
    result.removedPulp = Measured::of(of(volumes, MaterialRole::Pulp).removed);
    result.overEnamel = Measured::of(of(volumes, MaterialRole::Enamel).over);
    result.overDentin = Measured::of(of(volumes, MaterialRole::Dentin).over);
    result.underEnamel = Measured::of(of(volumes, MaterialRole::Enamel).under);
    result.underDentin = Measured::of(of(volumes, MaterialRole::Dentin).under);
    const TriangleMesh decay = decayOf(*preparation.tooth);
    const ColumnGrid columns(preparation.axis, decay, decay, spacing);
    const PreparedVolumes::Tissue all = of(preparedVolumes(preparation, columns), MaterialRole::Decay);
    const double removed = all.removed, kept = all.kept;
    if (!(removed + kept > 0)) {
        result.removedDecay = result.decayLeft = result.decayShare = Measured::none(msg::kNoDecayKnown);
        return result;
    }
    result.removedDecay = Measured::of(removed);
    result.decayLeft = Measured::of(kept);
    result.decayShare = Measured::of(removed / (removed + kept));
    return result;
}

}  // namespace tactooth
