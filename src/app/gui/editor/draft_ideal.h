// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "assessment/cavity_ghost.h"
#include "assessment/exercise.h"
#include "session/model/task.h"

namespace tactooth {

/// The ideal cavity of a draft in its tooth.
struct IdealCavity {
    std::shared_ptr<CavityGhost> ghost;
    std::optional<double> toPulp;  ///< leastToPulp, mm
};

/// Makes the ideal cavity of a draft in the background, and makes it anew when the draft has changed. All functions are
/// for one thread.
class DraftIdeal {
public:
    explicit DraftIdeal(const TaskExecutor& executor = runInThread) : task_(executor) {}
    ~DraftIdeal() { clear(); }
    DraftIdeal(const DraftIdeal&) = delete;
    DraftIdeal& operator=(const DraftIdeal&) = delete;

    /// Makes the cavity of `exercise` in its `tooth`, unless it is there or being made already. What was made or begun
    /// before is dropped.
    void follow(const Exercise& exercise, const std::shared_ptr<const LayeredTooth>& tooth);
    /// Whether the last call of `follow` was for the same cavity in the same tooth. Not after `clear`.
    [[nodiscard]] bool isOf(const Exercise& exercise, const std::shared_ptr<const LayeredTooth>& tooth) const;
    /// Drops it.
    void clear();
    /// Takes over what is ready; returns whether something was. Call it often.
    bool poll();

    [[nodiscard]] bool isPreparing() const { return task_.isAwaited(); }
    /// The share of the work that is done, 0..1.
    [[nodiscard]] double share() const { return work_ != nullptr ? work_->share.load() : 0; }
    /// Of the draft as it is now; nothing: it is not ready, or it cannot be made.
    [[nodiscard]] const std::optional<IdealCavity>& cavity() const { return cavity_; }
    /// Why it cannot be made, one sentence; nothing: it can, or nobody knows yet.
    [[nodiscard]] const std::optional<Message>& fault() const { return fault_; }

private:
    /// What the cavity follows from.
    struct Source {
        decltype(Exercise::ideal) ideal;
        decltype(Exercise::bur) bur;
        std::shared_ptr<const LayeredTooth> tooth;

        bool operator==(const Source&) const = default;
    };
    /// Work that has begun. Any thread.
    struct Work {
        std::atomic<double> share = 0;
        std::atomic<bool> isWanted = true;
    };

    std::optional<Source> source_;
    std::optional<IdealCavity> cavity_;
    std::optional<Message> fault_;
    std::shared_ptr<Work> work_;  // the newest
    Task<IdealCavity> task_;
};

}  // namespace tactooth
