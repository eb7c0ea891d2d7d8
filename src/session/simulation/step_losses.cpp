// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/step_losses.h"

#include <algorithm>

#include "geometry/util/assert.h"

namespace tactooth {

void StepLosses::follow(std::size_t undoable, std::size_t redoable) {
    TACTOOTH_ASSERT(undoable <= done_.size() + 1);
    if (undoable > done_.size()) done_.push_back(next_);
    done_.erase(done_.begin(), done_.begin() + static_cast<std::ptrdiff_t>(done_.size() - undoable));
    TACTOOTH_ASSERT(redoable == undone_.size() || redoable == 0);
    if (redoable == 0) undone_.clear();
}

/// What is changed next without a mark is a stroke that begins here.
ToothLoss StepLosses::move(std::vector<Entry>& from, std::vector<Entry>& to, const ToothLoss& now) {
    TACTOOTH_ASSERT(!from.empty());
    const Entry entry = from.back();
    from.pop_back();
    to.push_back({entry.step, now});
    next_ = {{CutStep::Kind::Stroke, entry.step.time}, entry.loss};
    return entry.loss;
}

ToothLoss StepLosses::undo(const ToothLoss& now) { return move(done_, undone_, now); }

ToothLoss StepLosses::redo(const ToothLoss& now) { return move(undone_, done_, now); }

CutHistory StepLosses::history() const {
    CutHistory history;
    std::ranges::transform(done_, std::back_inserter(history.done), &Entry::step);
    std::ranges::transform(undone_, std::back_inserter(history.undone), &Entry::step);
    return history;
}

}  // namespace tactooth
