// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "session/simulation/cut_history.h"
#include "session/simulation/tooth_loss.h"

namespace tactooth {

/// The loss of the tooth before and after each step of its CutVolume, which knows the nodes alone. The volume decides
/// when a step begins (at the first change after a mark), when the oldest is forgotten, and when nothing is left to
/// redo. `follow` brings this object up to its numbers.
class StepLosses {
public:
    /// The next change of the volume begins this step. `loss`: now. Call `follow` before it.
    void mark(const CutStep& step, const ToothLoss& loss) { next_ = {step, loss}; }
    /// `undoable`, `redoable`: of the volume now.
    void follow(std::size_t undoable, std::size_t redoable);
    /// The volume has undone its last step. `now`: the loss after that step. Returns the loss before it.
    [[nodiscard]] ToothLoss undo(const ToothLoss& now);
    /// The volume has redone a step. `now`: the loss before it. Returns the loss after it.
    [[nodiscard]] ToothLoss redo(const ToothLoss& now);
    [[nodiscard]] CutHistory history() const;

private:
    struct Entry {
        CutStep step;
        ToothLoss loss;  // before a step that is done, after one that is undone
    };
    [[nodiscard]] ToothLoss move(std::vector<Entry>& from, std::vector<Entry>& to, const ToothLoss& now);

    Entry next_;
    std::vector<Entry> done_, undone_;
};

}  // namespace tactooth
