// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/process/hand_work.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "assessment/agreement/median.h"
#include "assessment/messages.h"
#include "assessment/process/movement.h"
#include "geometry/util/degree.h"

namespace tactooth {
namespace {

constexpr double kLongestTick = 0.05;      // s: the slowest loops make 20 ticks a second
constexpr double kLeastSpeed = 100;        // rpm: a slower bur stands
constexpr double kShortest = 0.05;         // s: of strokes and of gaps between them
constexpr double kShortestMovement = 0.3;  // s: a shorter stroke says nothing about its smoothness
constexpr double kPause = 1;               // s
constexpr double kLeastPath = 0.1;         // mm in all strokes: less is no movement
constexpr double kLargeForce = 2;          // N: above what experts use
constexpr double kRate = 1000;             // Hz: of the samples that are filtered
constexpr double kCutoff = 20;             // Hz: hands are slower; faster is the noise of sensors
constexpr std::size_t kEach = 10;          // samples: the speed is taken at 100 Hz
constexpr double kSpeedRate = kRate / kEach;

Measured median(std::vector<double> values, const MessageText& reason) {
    const auto middle = medianOf(std::move(values));
    return middle ? Measured::of(*middle) : Measured::none(reason);
}

}  // namespace

void HandWorkMeter::add(const TrackTick& tick) {
    if (firstTime_ < 0) firstTime_ = tick.time;
    if (!tick.placed) return interrupt();
    if (!movement_.empty()) {
        const double since = tick.time - movement_.back().time;
        movement_.back().duration = std::clamp(since, 0.0, kLongestTick);
        if (since > kLongestTick) interrupt();
    }
    lastTime_ = tick.time;
    const auto norm = [](const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); };
    const auto& turn = tick.rotation;
    const Vec3 shaft = Quat(turn[3], turn[0], turn[1], turn[2]) * Vec3::UnitZ();
    movement_.push_back({.time = tick.time,
                         .duration = 0,
                         .place = {tick.position[0], tick.position[1], tick.position[2]},
                         .force = norm(tick.force),
                         .tilt = std::acos(std::clamp(shaft.dot(axis_), -1.0, 1.0)),
                         .touches = tick.contacts > 0,
                         .turns = tick.speedRpm > kLeastSpeed});
}

void HandWorkMeter::interrupt() {
    if (movement_.size() > 1) endMovement();
    movement_.clear();
}

void HandWorkMeter::endMovement() {
    for (const Moment& each : movement_) {
        if (each.turns) (each.touches ? work_.drilling : work_.idle) += each.duration;
        if (each.turns && each.touches) tilt_ += each.duration * each.tilt;
        if (!each.turns && !each.touches) {
            pause_ += each.duration;
        } else {
            if (pause_ > kPause) work_.dead += pause_;
            pause_ = 0;
        }
        if (each.touches) held_.push_back({each.force, each.duration});
    }
    // The tip at equal intervals, without tremor that no hand makes.
    std::array<std::vector<double>, 3> coordinates;
    const double begin = movement_.front().time, end = movement_.back().time;
    const auto count = static_cast<std::size_t>((end - begin) * kRate) + 1;
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double time = begin + static_cast<double>(i) / kRate;
        while (at + 2 < movement_.size() && movement_[at + 1].time <= time) ++at;
        const Moment &before = movement_[at], &after = movement_[at + 1];
        const double span = after.time - before.time;
        const double share = span > 0 ? std::clamp((time - before.time) / span, 0.0, 1.0) : 0;
        const Vec3 place = before.place + share * (after.place - before.place);
        for (std::size_t axis = 0; axis < 3; ++axis)
            coordinates[axis].push_back(place[static_cast<Eigen::Index>(axis)]);
    }
    for (auto& each : coordinates) each = lowPassed(each, kRate, kCutoff);
    Smoothed smoothed;
    for (std::size_t i = 0; i < count; i += kEach) {
        smoothed.places.emplace_back(coordinates[0][i], coordinates[1][i], coordinates[2][i]);
        if (i == 0) continue;
        const double step = (smoothed.places.back() - smoothed.places.end()[-2]).norm();
        smoothed.speed.push_back(step * kSpeedRate);
        work_.path += step;
    }
    for (const Stroke& stroke : strokes()) addStroke(stroke, smoothed);
}

std::vector<HandWorkMeter::Stroke> HandWorkMeter::strokes() const {
    std::vector<Stroke> found;
    for (std::size_t i = 0; i < movement_.size(); ++i) {
        if (!movement_[i].touches || !movement_[i].turns) continue;
        const double gap = found.empty() ? kShortest : movement_[i].time - movement_[found.back().last].time;
        if (gap < kShortest) {
            found.back().last = i;
        } else {
            found.push_back({i, i});
        }
    }
    std::erase_if(found, [&](const Stroke& stroke) {
        return movement_[stroke.last].time - movement_[stroke.first].time <= kShortest;
    });
    return found;
}

void HandWorkMeter::addStroke(const Stroke& stroke, const Smoothed& smoothed) {
    const double begin = movement_[stroke.first].time, end = movement_[stroke.last].time;
    ++work_.strokes;
    strokeTimes_.push_back(end - begin);
    double time = 0, sum = 0, squares = 0;
    for (std::size_t i = stroke.first; i <= stroke.last; ++i) {
        const double duration = movement_[i].duration, force = movement_[i].force;
        time += duration;
        sum += duration * force;
        squares += duration * force * force;
    }
    if (time > 0) {
        strokeTime_ += time;
        strokeVariance_ += std::max(0.0, squares - sum * sum / time);
    }
    const auto sample = [&](double at) {
        const double number = (at - movement_.front().time) * kSpeedRate;
        return std::min(smoothed.speed.size(), static_cast<std::size_t>(std::max(0.0, number)));
    };
    const std::size_t first = sample(begin), last = sample(end);
    const std::span movement = std::span(smoothed.speed).subspan(first, last - first);
    for (const double each : movement) strokePath_ += each / kSpeedRate;
    strokeSpan_ += (smoothed.places[last] - smoothed.places[first]).norm();
    if (end - begin <= kShortestMovement) return;
    if (const auto value = spectralArcLength(movement, kSpeedRate)) arcLengths_.push_back(*value);
    if (const auto value = logDimensionlessJerk(movement, kSpeedRate)) jerks_.push_back(*value);
    if (const auto value = frequency95(movement, kSpeedRate)) frequencies_.push_back(*value);
}

void HandWorkMeter::addForces(HandWork& work) {
    double time = 0, over = 0, peak = 0, squares = 0;
    for (const Held& each : held_) {
        time += each.duration;
        work.impulse += each.duration * each.force;
        squares += each.duration * each.force * each.force;
        if (each.force > kLargeForce) over += each.duration;
        peak = std::max(peak, each.force);
    }
    work.forceMean = work.impulse / time;
    work.forceRms = std::sqrt(squares / time);
    work.forcePeak = peak;
    work.forceOver2 = over / time;
    std::ranges::sort(held_, {}, &Held::force);
    constexpr double kShare = 0.95;
    double below = 0;
    for (const Held& each : held_) {
        below += each.duration;
        if (below < kShare * time) continue;
        work.forceP95 = each.force;
        break;
    }
}

Measured HandWorkMeter::economy() const {
    if (strokeTimes_.empty()) return Measured::none(msg::kNoStroke);
    if (strokePath_ < kLeastPath) return Measured::none(msg::kStrokesWithoutPath);
    return Measured::of(strokeSpan_ / strokePath_);
}

std::optional<HandWork> HandWorkMeter::finish() {
    interrupt();
    if (std::ranges::none_of(held_, [](const Held& each) { return each.duration > 0; })) return std::nullopt;
    HandWork work = work_;
    if (pause_ > kPause) work.dead += pause_;
    work.seconds = std::max(0.0, lastTime_ - std::max(0.0, firstTime_));
    addForces(work);
    work.burTilt =
        work.drilling > 0 ? Measured::of(tilt_ / work.drilling / kDegree) : Measured::none(msg::kNeverDrilled);
    work.strokeTime = median(strokeTimes_, msg::kNoStroke);
    work.economy = economy();
    work.arcLength = median(arcLengths_, msg::kNoLongStroke);
    work.jerk = median(jerks_, msg::kNoLongStroke);
    work.frequency95 = median(frequencies_, msg::kNoLongStroke);
    work.forceSpread =
        strokeTime_ > 0 ? Measured::of(std::sqrt(strokeVariance_ / strokeTime_)) : Measured::none(msg::kNoStroke);
    return work;
}

std::optional<HandWork> handWork(const SessionTrack& track, const Vec3& axis) {
    HandWorkMeter meter(axis);
    std::shared_ptr<const TrackBur> bur;
    std::uint64_t moment = 0;
    track.forEachTick(0, track.ticks(), [&](const TrackTick& tick) {
        auto now = track.burAt(++moment);
        if (now != bur) meter.interrupt();
        bur = std::move(now);
        meter.add(tick);
    });
    return meter.finish();
}

}  // namespace tactooth
