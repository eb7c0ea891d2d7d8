// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "session/kernel/session_event.h"
#include "session/simulation/cut_events.h"
#include "session/simulation/cut_history.h"

namespace tactooth {

/// One thing that the user did and can undo.
struct WorkStep {
    Message name;
    double time = 0;                   ///< when it was done: s since the list of events began
    std::function<void()> undo, redo;  ///< empty for a step of cutting, which the tooth itself undoes
    /// Equal kinds that follow each other within a second are one step: a slider that is moved. 0: never.
    int kind = 0;
};

/// All that the user did with a tooth, in one order: strokes and resets, which the tooth itself keeps, and other
/// changes, such as another bur. What was undone is kept until something else is done. One thread.
class WorkHistory {
public:
    /// Oldest first.
    [[nodiscard]] const std::vector<WorkStep>& steps() const { return steps_; }
    /// How many of them are done; those behind are undone.
    [[nodiscard]] std::size_t position() const { return position_; }
    /// Counts the changes of steps or position, so that a panel knows when to show them anew.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

    /// Another tooth.
    void clear();
    /// A change that is no cut was made.
    void add(WorkStep step);
    /// Brings it up to what the tooth has: new strokes, undone and redone ones. Takes back or brings back their events.
    /// `now`, `simulatorBegan`: on the time scale of `events`, s; the times of `cuts` are those of the runner.
    void follow(const CutHistory& cuts, CutEvents& events, double now, double simulatorBegan);

    /// The same without the changes that are no cuts: for another window that goes on with the tooth.
    [[nodiscard]] WorkHistory cutsAlone() const;
    /// Whether something is being undone or redone.
    [[nodiscard]] bool isBusy() const { return isWaiting_ || goal_.has_value(); }
    /// The share of the way to the goal that is done, 0..1; none: nothing is being undone or redone.
    [[nodiscard]] std::optional<double> share() const;
    /// Goes back to where it was when undoing or redoing began.
    void giveUp();
    /// Whether it does so already.
    [[nodiscard]] bool isGivingUp() const { return isGivingUp_; }
    /// Another runner: it does not answer a request to the one before.
    void restart() { isWaiting_ = false; }

    /// Undoes or redoes steps until `position` of them are done. `advance` does it.
    void goTo(std::size_t position);
    void undo() { goTo(goal_.value_or(position_) - (goal_.value_or(position_) > 0 ? 1 : 0)); }
    void redo() { goTo(goal_.value_or(position_) + 1); }
    /// Goes on towards the goal. Returns the next request to the runner; nothing while it has not answered the last
    /// one, or if there is nothing to do.
    [[nodiscard]] std::optional<Edit> advance();

private:
    struct Cut {
        CutStep step;
        double begin = 0, end = 0;  // of its events, s
        std::vector<std::size_t>
            events;  // that it has taken back: a stroke while it is undone, a reset while it is done
    };
    struct Alignment {
        std::size_t forgotten = 0, same = 0;
    };

    [[nodiscard]] std::vector<std::size_t> cutPlaces() const;
    [[nodiscard]] Alignment align(const std::vector<CutStep>& all) const;
    void forget(std::size_t cuts);
    void dropUndone();
    void insert(std::size_t at, WorkStep step, std::optional<Cut> cut);
    void setDone(std::size_t place, bool isDone, CutEvents& events, double now);
    [[nodiscard]] double endOf(std::size_t place, double now) const;

    std::vector<WorkStep> steps_;
    std::vector<std::optional<Cut>> cuts_;  // of each step
    std::size_t position_ = 0;
    std::optional<std::size_t> goal_;
    std::size_t start_ = 0;  // the position when there was no goal yet
    bool isGivingUp_ = false;
    bool isWaiting_ = false;  // for the runner
    std::uint64_t revision_ = 0;
};

}  // namespace tactooth
