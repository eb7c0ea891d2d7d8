// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cause/removal_cause.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace tactooth {
namespace {

constexpr double kPause = 0.5;    // s
constexpr double kContext = 0.1;  // s around the removals: the ticks in which the bur was there

/// Finds the times of many points in one walk through the track: all points of a call are there at `there` and gone at
/// `gone`.
class RemovalSearch {
public:
    RemovalSearch(const SessionTrack& track, TrackTooth& tooth, const std::vector<RemovedPoint>& points, double step)
        : track_(track), tooth_(tooth), points_(points), step_(step), times_(points.size()) {}

    std::vector<std::optional<double>> run() {
        const std::uint64_t end = track_.ticks();
        std::vector<std::size_t> all;
        if (end == 0) return times_;
        tooth_.moveTo(0);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (!isGone(i)) all.push_back(i);
        }
        tooth_.moveTo(end);
        std::erase_if(all, [this](std::size_t i) { return !isGone(i); });
        split(0, end, std::move(all));
        return std::move(times_);
    }

private:
    [[nodiscard]] bool isGone(std::size_t point) const {
        return tooth_.model().volume().cutDistance(points_[point].place) < 0;
    }
    [[nodiscard]] double timeOf(std::uint64_t moment) const { return moment == 0 ? 0 : track_.tickBefore(moment).time; }

    void split(std::uint64_t there, std::uint64_t gone, std::vector<std::size_t> points) {
        if (points.empty()) return;
        if (gone - there <= 1 || timeOf(gone) - timeOf(there) < step_) {
            for (const std::size_t i : points) times_[i] = timeOf(gone);
            return;
        }
        const std::uint64_t middle = there + (gone - there) / 2;
        tooth_.moveTo(middle);
        const auto later = std::ranges::partition(points, [this](std::size_t i) { return isGone(i); });
        std::vector<std::size_t> after(later.begin(), later.end());
        points.erase(later.begin(), later.end());
        split(there, middle, std::move(points));
        split(middle, gone, std::move(after));
    }

    const SessionTrack& track_;
    TrackTooth& tooth_;
    const std::vector<RemovedPoint>& points_;
    double step_;  // s
    std::vector<std::optional<double>> times_;
};

struct PieceOfWork {
    double from, to;  // s
    double size;
};

/// The piece of work that has removed most.
std::optional<PieceOfWork> largestPiece(std::span<const RemovedPoint> points,
                                        std::span<const std::optional<double>> times) {
    std::vector<std::pair<double, double>> removals;  // time and size
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (times[i]) removals.emplace_back(*times[i], points[i].size);
    }
    std::ranges::sort(removals);
    std::optional<PieceOfWork> largest, now;
    for (const auto& [time, size] : removals) {
        if (now && time - now->to < kPause) {
            now->to = time;
            now->size += size;
        } else {
            now = PieceOfWork{time, time, size};
        }
        if (!largest || now->size > largest->size || now->from == largest->from) largest = now;
    }
    return largest;
}

RemovalCause causeOf(const PieceOfWork& work, const SessionTrack& track, const Vec3& axis) {
    double force = 0, tilt = 0;
    std::size_t count = 0;
    track.forEachTick(track.momentAt(work.from - kContext), track.momentAt(work.to + kContext),
                      [&](const TrackTick& kept) {
                          const Tick tick = kept.tick();
                          if (tick.contact.triangles == 0) return;
                          const Vec3 shaft = tick.contact.proxy.rotation * Vec3::UnitZ();
                          force += tick.force.wrench.force.norm();
                          tilt += std::acos(std::clamp(shaft.dot(axis), -1.0, 1.0));
                          ++count;
                      });
    RemovalCause cause{work.from, work.to, 0};
    if (count == 0) return cause;  // a file of poses led the bur: nothing touched
    const auto ticks = static_cast<double>(count);
    cause.force = force / ticks;
    cause.tilt = tilt / ticks * 180 / std::numbers::pi;
    return cause;
}

}  // namespace

std::vector<std::optional<double>> removalTimes(const SessionTrack& track, TrackTooth& tooth,
                                                const std::vector<RemovedPoint>& points, double step) {
    return RemovalSearch(track, tooth, points, step).run();
}

std::vector<std::optional<RemovalCause>> removalCauses(const SessionTrack& track, TrackTooth& tooth,
                                                       const std::vector<std::vector<RemovedPoint>>& errors,
                                                       const Vec3& axis) {
    std::vector<RemovedPoint> all;
    for (const auto& points : errors) all.insert(all.end(), points.begin(), points.end());
    const auto times = removalTimes(track, tooth, all);
    std::vector<std::optional<RemovalCause>> causes;
    std::size_t first = 0;
    for (const auto& points : errors) {
        const auto work = largestPiece(points, std::span(times).subspan(first, points.size()));
        first += points.size();
        causes.push_back(work ? std::optional(causeOf(*work, track, axis)) : std::nullopt);
    }
    return causes;
}

}  // namespace tactooth
