// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/beginner/beginner_hand.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace tactooth::test {
namespace {

constexpr double kFree = 6;          // pixels between bur and pointer where nothing resists
constexpr double kFollowing = 20;    // pixels between bur and pointer that are no concern
constexpr double kSeenProgress = 1;  // pixels
constexpr double kRowShare = 0.5;    // of the bur's radius between two rows: they overlap by three quarters
constexpr int kPasses = 3;           // at least
constexpr double kMostPush = 15;     // pixels
constexpr double kAlongRim = 2;      // pixels between two places of the way round
constexpr double kRoughly = 0.8;     // of the ring: on a slope it looks narrower, and the hand then steers by it
constexpr int kAround = 24;          // places of a ring

bool isInside(const std::vector<Vec2>& outline, const Vec2& place) {
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Vec2 &a = outline[i], &b = outline[j];
        if ((a.y() > place.y()) != (b.y() > place.y()) &&
            place.x() < (b.x() - a.x()) * (place.y() - a.y()) / (b.y() - a.y()) + a.x())
            inside = !inside;
    }
    return inside;
}

/// Whether a circle lies within the outline.
bool fitsWithin(const std::vector<Vec2>& outline, const Vec2& middle, double radius) {
    for (int i = 0; i < kAround; ++i) {
        const double angle = 2 * std::numbers::pi * i / kAround;
        if (!isInside(outline, middle + radius * Vec2(std::cos(angle), std::sin(angle)))) return false;
    }
    return true;
}

Vec2 middleOf(const std::vector<Vec2>& points) {
    Vec2 low = points.front(), high = low;
    for (const Vec2& point : points) low = low.cwiseMin(point), high = high.cwiseMax(point);
    return (low + high) / 2;
}

}  // namespace

std::vector<HandPlace> rowsWithin(const std::vector<Vec2>& outline, double radius) {
    // The longer side: the main axis of the outline.
    Vec2 mean = Vec2::Zero();
    for (const Vec2& point : outline) mean += point / static_cast<double>(outline.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Vec2& point : outline) spread += (point - mean) * (point - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
    const Vec2 along = axes.eigenvectors().col(1), across = axes.eigenvectors().col(0);
    double low = 0, high = 0, left = 0, right = 0;
    for (const Vec2& point : outline) {
        low = std::min(low, along.dot(point - mean)), high = std::max(high, along.dot(point - mean));
        left = std::min(left, across.dot(point - mean)), right = std::max(right, across.dot(point - mean));
    }
    std::vector<HandPlace> places;
    bool forth = true;
    const double width = std::max(0.0, right - left - 2 * radius);
    const int rows = 1 + static_cast<int>(std::ceil(width / std::max(1.0, kRowShare * radius)));
    for (int i = 0; i < rows; ++i) {
        const double row = (left + right) / 2 + (rows > 1 ? width * (static_cast<double>(i) / (rows - 1) - 0.5) : 0);
        std::vector<HandPlace> line;
        for (double column = low; column <= high; column += 1) {
            const Vec2 place = mean + column * along + row * across;
            if (fitsWithin(outline, place, radius)) line.push_back({place, {}});
        }
        if (line.empty()) continue;
        if (!forth) std::ranges::reverse(line);
        forth = !forth;
        places.insert(places.end(), line.begin(), line.end());
    }
    return places;
}

std::vector<HandPlace> wayRound(const std::vector<Vec2>& outline, double radius) {
    double area = 0;  // twice, signed: which side is within
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        area += outline[j].x() * outline[i].y() - outline[i].x() * outline[j].y();
    }
    const double side = area > 0 ? 1 : -1;
    std::vector<HandPlace> places;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Vec2 step = outline[i] - outline[j];
        if (step.norm() == 0) continue;
        const Vec2 inward = side * Vec2(-step.y(), step.x()).normalized();
        for (double done = 0; done < step.norm(); done += kAlongRim) {
            const Vec2 rim = outline[j] + done / step.norm() * step;
            const Vec2 place = rim + radius * inward;
            if (fitsWithin(outline, place, kRoughly * radius)) places.push_back({place, HandPlace::Rim{rim, -inward}});
        }
    }
    if (!places.empty()) places.push_back(places.front());
    return places;
}

BeginnerHand::BeginnerHand(unsigned seed, const Habits& habits, double goalDepth, double pixelPitch)
    : habits_(habits), goalDepth_(goalDepth), pixelPitch_(pixelPitch), random_(seed) {}

Vec2 BeginnerHand::tremble(const Vec2& place) {
    std::normal_distribution<double> tremor(0, habits_.tremor);
    const double x = tremor(random_), y = tremor(random_);
    return {std::round(place.x() + x), std::round(place.y() + y)};  // a mouse has whole pixels
}

void BeginnerHand::plan(const SeenPicture& seen) {
    const Vec2 ringMiddle = middleOf(seen.ring);
    double radius = 0;
    for (const Vec2& point : seen.ring) radius += (point - ringMiddle).norm() / static_cast<double>(seen.ring.size());
    path_ = rowsWithin(seen.outline, radius);
    std::ranges::copy(wayRound(seen.outline, radius), std::back_inserter(path_));
    if (path_.empty()) path_.push_back({middleOf(seen.outline), {}});
    for (HandPlace& place : path_) place.at += seen.landing - ringMiddle;  // the pointer is at the landing place
    at_ = on_ = path_.front().at;
}

/// Where the ring does not touch the outline, or is over it, the hand goes by this farther out or in.
void BeginnerHand::steerToRim(double dt, const SeenPicture& seen, double behind) {
    const std::optional<HandPlace::Rim>& rim = path_[place_].rim;
    const bool isBeside = rim && (on_ - path_[place_].at).norm() < 2 * kAlongRim;
    if (!isBeside || seen.ring.empty() || behind > kFree) return;
    double reach = -std::numeric_limits<double>::infinity();
    for (const Vec2& point : seen.ring) reach = std::max(reach, (point - rim->place).dot(rim->outward));
    push_ = std::clamp(push_ - reach * dt / (2 * habits_.reaction), -kMostPush, kMostPush);
}

/// On along the path.
void BeginnerHand::goOn(double dt) {
    const double speed = path_[place_].rim ? habits_.speed / 2 : habits_.speed;
    for (double left = speed * dt / pixelPitch_; left > 0 && place_ + 1 < path_.size();) {
        const Vec2 toNext = path_[place_ + 1].at - on_;
        if (toNext.norm() > left) {
            on_ += toNext.normalized() * left;
            break;
        }
        left -= toNext.norm();
        on_ = path_[++place_].at;
    }
}

BeginnerHand::Action BeginnerHand::next(double dt, const SeenPicture& picture) {
    time_ += dt;
    seen_.push_back({time_, picture, at_});
    while (seen_.size() > 1 && seen_[1].time <= time_ - habits_.reaction) seen_.pop_front();
    if (seen_.front().time > time_ - habits_.reaction) return {tremble(at_), button_, false};  // nothing seen yet
    const SeenPicture& seen = seen_.front().picture;
    if (path_.empty()) {
        if (seen.outline.empty()) return {tremble(at_), button_, false};
        at_ = middleOf(seen.outline);
        // First to the middle, to see how large the ring is there.
        if (seen.ring.empty() || (middleOf(seen.ring) - at_).norm() > 8) return {tremble(at_), button_, false};
        plan(seen);
        waited_ = 0;
    }
    waited_ += dt;
    if (button_ == Button::Up) {
        if (waited_ > 2 * habits_.reaction) button_ = Button::Down, waited_ = 0;
        return {tremble(at_), button_, false};
    }
    // Waits for the bur as long as it gets on.
    const bool isDeep = seen.depth && *seen.depth > goalDepth_ - habits_.tolerance;
    const bool isAtRim = path_[place_].rim.has_value();
    const double behind = seen.ring.empty() ? 0 : (seen.landing - seen_.front().at).norm();
    const double toDo = (isDeep ? 0 : goalDepth_ - seen.depth.value_or(0)) / pixelPitch_ + behind;
    if (toDo < leastToDo_ - kSeenProgress) leastToDo_ = toDo, waited_ = 0;
    const double allowed = isAtRim ? kFree : kFollowing;
    if ((!isDeep || behind > allowed) && waited_ < habits_.patience) {
        waitedInPass_ += dt;
        return {tremble(at_), button_, false};
    }
    leastToDo_ = std::numeric_limits<double>::infinity();
    if (isDeep) waited_ = 0;
    steerToRim(dt, seen, behind);
    goOn(dt);
    at_ = on_ + (path_[place_].rim ? Vec2(push_ * path_[place_].rim->outward) : Vec2(Vec2::Zero()));
    const bool isAtEnd = place_ + 1 >= path_.size();
    const bool isDone = isAtEnd && ((waitedInPass_ < habits_.patience && pass_ >= kPasses) || time_ > habits_.longest);
    if (isAtEnd && !isDone) {  // once more, the other way
        std::ranges::reverse(path_);
        place_ = 0;
        ++pass_;
        waitedInPass_ = 0;
    }
    if (isDone) button_ = Button::Up;
    return {tremble(at_), button_, isDone};
}

}  // namespace tactooth::test
