// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>

#include "geometry/util/fnv1a.h"
#include "session/kernel/instrument.h"
#include "session/kernel/session_event.h"
#include "session/simulation/cut_model.h"

namespace tactooth {

/// The part of a session that the carving thread runs: it cuts behind the tool. Equal calls give equal teeth, bit for
/// bit.
class CarvingStage {
public:
    /// The model is not null; it may already be cut. `materials`: those of the tooth.
    CarvingStage(std::shared_ptr<CutModel> model, const Instrument& instrument, MaterialTable materials);

    /// Cuts toward the tick's device pose, or removes detached pieces once the bur was lifted. Returns true if the
    /// surface has changed.
    bool carve(const Tick& tick);
    /// Returns true if the surface has changed.
    bool edit(Edit edit);
    /// The end of a run that is not live: detached pieces fall, if `dropsPieces`, and the surface is up to date.
    /// Returns true if it has changed.
    bool finish(bool dropsPieces);

    [[nodiscard]] const CutModel& model() const { return *model_; }
    /// Hash of all turns so far: what each has removed, and where the cut ended. It costs next to nothing, unlike that
    /// of the whole tooth (CutModel::hash).
    [[nodiscard]] std::uint64_t hash() const { return hash_.value(); }

private:
    bool addToHash(bool changed);
    [[nodiscard]] bool cutsAt(const Tick& tick) const;

    std::shared_ptr<CutModel> model_;
    CuttingTool tool_;
    bool scrapes_;  // an excavator: no drive
    MaterialTable materials_;
    Fnv1a hash_;
    double time_ = 0;                                            // Tick::time of the newest tick, s
    double lastCut_ = -std::numeric_limits<double>::infinity();  // Tick::time, s
};

}  // namespace tactooth
