// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/work_history.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "geometry/util/assert.h"
#include "session/model/messages.h"

namespace tactooth {
namespace {

constexpr double kOneStep = 1;               // s: changes of one kind that follow sooner are one step
constexpr std::size_t kMostSteps = 100'000;  // more than anybody does with a tooth; the oldest go

}  // namespace

void WorkHistory::clear() {
    steps_.clear();
    cuts_.clear();
    position_ = 0;
    goal_.reset();
    isWaiting_ = false;
    ++revision_;
}

void WorkHistory::dropUndone() {
    steps_.resize(position_);
    cuts_.resize(position_);
}

void WorkHistory::insert(std::size_t at, WorkStep step, std::optional<Cut> cut) {
    TACTOOTH_ASSERT(at <= steps_.size());
    steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(at), std::move(step));
    cuts_.insert(cuts_.begin() + static_cast<std::ptrdiff_t>(at), std::move(cut));
}

void WorkHistory::add(WorkStep step) {
    ++revision_;
    goal_.reset();
    // A cut that is undone can only be redone by the tooth itself, which forgets it with the next cut. Until then it
    // stays behind this step: what was undone and is of another kind cannot come back in its order.
    if (std::ranges::any_of(cuts_.begin() + static_cast<std::ptrdiff_t>(position_), cuts_.end(),
                            [](const auto& cut) { return cut.has_value(); })) {
        const auto isOther = [](const auto& cut) { return !cut.has_value(); };
        for (std::size_t i = steps_.size(); i-- > position_;) {
            if (!isOther(cuts_[i])) continue;
            steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(i));
            cuts_.erase(cuts_.begin() + static_cast<std::ptrdiff_t>(i));
        }
    } else {
        dropUndone();
    }
    const bool isSame = step.kind != 0 && position_ > 0 && steps_[position_ - 1].kind == step.kind &&
                        step.time < steps_[position_ - 1].time + kOneStep;
    if (isSame) {  // one way back, to before both
        step.undo = std::move(steps_[position_ - 1].undo);
        steps_[position_ - 1] = std::move(step);
        return;
    }
    insert(position_++, std::move(step), std::nullopt);
    if (steps_.size() <= kMostSteps) return;
    if (!cuts_.front()) {
        steps_.erase(steps_.begin());
        cuts_.erase(cuts_.begin());
        --position_;
    }
}

std::vector<std::size_t> WorkHistory::cutPlaces() const {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
        if (cuts_[i]) places.push_back(i);
    }
    return places;
}

/// Where the steps of the tooth, done and undone, continue those that are known: the tooth may have forgotten the
/// oldest, and those that were undone.
WorkHistory::Alignment WorkHistory::align(const std::vector<CutStep>& all) const {
    const std::vector<std::size_t> places = cutPlaces();
    Alignment best{places.size(), 0};
    for (std::size_t forgotten = 0; forgotten < places.size(); ++forgotten) {
        std::size_t same = 0;
        while (same < all.size() && forgotten + same < places.size() &&
               cuts_[places[forgotten + same]]->step == all[same]) {
            ++same;
        }
        if (same > best.same) best = {forgotten, same};
    }
    return best;
}

/// Drops the oldest cuts and what was done before them.
void WorkHistory::forget(std::size_t cuts) {
    if (cuts == 0) return;
    const std::size_t count = cutPlaces()[cuts - 1] + 1;
    steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(count));
    cuts_.erase(cuts_.begin(), cuts_.begin() + static_cast<std::ptrdiff_t>(count));
    position_ -= std::min(position_, count);
    goal_.reset();
}

/// A stroke lasts until the next one begins.
double WorkHistory::endOf(std::size_t place, double now) const {
    for (std::size_t i = place + 1; i < cuts_.size(); ++i) {
        if (cuts_[i]) return cuts_[i]->begin;
    }
    return now;
}

void WorkHistory::setDone(std::size_t place, bool isDone, CutEvents& events, double now) {
    Cut& cut = *cuts_[place];
    const bool takesBack = (cut.step.kind == CutStep::Kind::Reset) == isDone;
    if (!takesBack) {
        events.bringBack(cut.events);
        cut.events.clear();
    } else if (cut.step.kind == CutStep::Kind::Reset) {
        cut.events = events.takeBack(0, std::numeric_limits<double>::infinity());
    } else {
        if (cut.end == 0) cut.end = endOf(place, now);
        cut.events = events.takeBack(cut.begin, cut.end);
    }
}

void WorkHistory::follow(const CutHistory& cuts, CutEvents& events, double now, double simulatorBegan) {
    std::vector<CutStep> all = cuts.done;
    all.insert(all.end(), cuts.undone.rbegin(), cuts.undone.rend());
    const auto [forgotten, same] = align(all);
    const std::size_t known = cutPlaces().size();
    const bool isNew = all.size() > same || known > forgotten + same;
    const auto isDone = [&] {
        return static_cast<std::size_t>(std::count_if(cuts_.begin(),
                                                      cuts_.begin() + static_cast<std::ptrdiff_t>(position_),
                                                      [](const auto& cut) { return cut.has_value(); }));
    };
    if (!isNew && forgotten == 0 && isDone() == cuts.done.size()) return;
    ++revision_;
    isWaiting_ = false;
    forget(forgotten);
    if (isNew) {
        goal_.reset();
        const std::vector<std::size_t> places = cutPlaces();
        while (same < places.size() && position_ > places[same]) {  // undone, and forgotten since
            --position_;
            if (cuts_[position_]) setDone(position_, false, events, now);
        }
        dropUndone();
        for (std::size_t i = cutPlaces().size(); i < all.size(); ++i) {
            const bool isReset = all[i].kind == CutStep::Kind::Reset;
            const double begin = simulatorBegan + all[i].time;
            Cut cut{all[i], begin, 0, {}};
            insert(position_++, {Message(isReset ? msg::kStepReset : msg::kStepStroke), begin, {}, {}, 0},
                   std::move(cut));
            if (isReset) setDone(position_ - 1, true, events, now);
        }
    }
    for (const std::size_t place : cutPlaces()) {  // undone
        if (isDone() > cuts.done.size() || place < position_) continue;
        if (isDone() == cuts.done.size()) break;
        position_ = place + 1;
        setDone(place, true, events, now);
    }
    while (isDone() > cuts.done.size()) {
        --position_;
        if (cuts_[position_]) setDone(position_, false, events, now);
    }
}

WorkHistory WorkHistory::cutsAlone() const {
    WorkHistory alone;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        if (!cuts_[i]) continue;
        alone.insert(alone.steps_.size(), steps_[i], cuts_[i]);
        if (i < position_) ++alone.position_;
    }
    return alone;
}

void WorkHistory::goTo(std::size_t position) {
    if (!goal_) start_ = position_;
    isGivingUp_ = false;
    goal_ = std::min(position, steps_.size());
}

std::optional<double> WorkHistory::share() const {
    if (!goal_) return std::nullopt;
    const auto distance = [](std::size_t a, std::size_t b) {
        return static_cast<double>(std::max(a, b) - std::min(a, b));
    };
    const double done = distance(start_, position_), left = distance(position_, *goal_);
    return done + left > 0 ? done / (done + left) : 0;
}

void WorkHistory::giveUp() {
    if (!goal_ || isGivingUp_) return;
    const std::size_t before = std::exchange(start_, position_);
    goal_ = std::min(before, steps_.size());
    isGivingUp_ = true;
}

std::optional<Edit> WorkHistory::advance() {
    while (goal_ && !isWaiting_) {
        if (*goal_ == position_) {
            goal_.reset();
            break;
        }
        const bool isBack = *goal_ < position_;
        const std::size_t place = isBack ? position_ - 1 : position_;
        if (cuts_[place]) {
            isWaiting_ = true;
            return isBack ? Edit::Undo : Edit::Redo;
        }
        const std::function<void()> change = isBack ? steps_[place].undo : steps_[place].redo;
        position_ = isBack ? place : place + 1;
        ++revision_;
        if (change) change();
    }
    return std::nullopt;
}

}  // namespace tactooth
