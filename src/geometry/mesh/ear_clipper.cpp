// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/ear_clipper.h"

#include <algorithm>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

/// A triangle is flat if its doubled area is less than this share of the square of its longer edge at the ear: corners
/// written with five digits are as far from their ideal line.
constexpr double kFlat = 1e-4;

}  // namespace

void EarClipper::begin(const ProjectedPolygon& outline, std::size_t maxTests) {
    TACTOOTH_ASSERT(outline.size() >= 3);
    outline_ = &outline;
    left_ = outline.size();
    tests_ = 0;
    maxTests_ = maxTests;
    next_.resize(left_);
    previous_.resize(left_);
    for (Corner corner = 0; corner < left_; ++corner) {
        next_[corner] = corner + 1 == left_ ? 0 : corner + 1;
        previous_[next_[corner]] = corner;
    }
    mayBlock_.assign(left_, false);
    blockers_.clear();
    for (Corner corner = 0; corner < left_; ++corner) {
        mayBlock_[corner] = !turnsClearly(corner);
        if (mayBlock_[corner]) blockers_.push_back(corner);
    }
    liveBlockers_ = blockers_.size();
    std::ranges::sort(blockers_, [&](Corner a, Corner b) {
        return outline.x(a) < outline.x(b) || (outline.x(a) == outline.x(b) && a < b);
    });
}

EarClipper::Result EarClipper::clip(const ProjectedPolygon& outline, std::size_t maxTests,
                                    std::vector<Triangle>& triangles) {
    begin(outline, maxTests);
    Corner ear = 0;
    for (bool goesBack = false; left_ > 3; goesBack = !goesBack) {
        if (!findEar(ear, EarPolicy::NoFlatEar) && !findEar(ear, EarPolicy::AnyEar))
            return tests_ > maxTests_ ? Result::LimitReached : Result::NoEar;
        const Corner a = previous_[ear], c = next_[ear];
        triangles.push_back({outline.vertex(a), outline.vertex(ear), outline.vertex(c)});
        remove(ear);
        // Alternate between the corners before and behind the ear: along a band this gives short triangles, and not a
        // fan of ever longer ones.
        ear = removeSpikes(a);
        if (!goesBack) ear = next_[ear];
    }
    if (left_ < 3) return Result::Done;
    const Corner a = previous_[ear], c = next_[ear];
    if (outline.side(a, ear, c) <= 0) return Result::NoEar;
    triangles.push_back({outline.vertex(a), outline.vertex(ear), outline.vertex(c)});
    return Result::Done;
}

/// The next ear from `from` on; `from` stays unchanged if there is none.
bool EarClipper::findEar(Corner& from, EarPolicy policy) {
    Corner corner = from;
    for (std::size_t step = 0; step < left_ && tests_ <= maxTests_; ++step, corner = next_[corner]) {
        if (!isEar(corner, policy)) continue;
        from = corner;
        return true;
    }
    return false;
}

bool EarClipper::isEar(Corner ear, EarPolicy policy) {
    const Corner a = previous_[ear], c = next_[ear];
    ++tests_;
    if (policy == EarPolicy::NoFlatEar ? !turnsClearly(ear) : outline_->side(a, ear, c) <= 0) return false;
    if (!isWithinCorners(a, c, ear)) return false;
    const auto [least, most] = std::minmax({outline_->x(a), outline_->x(ear), outline_->x(c)});
    auto each = std::ranges::lower_bound(blockers_, least, {}, [&](Corner corner) { return outline_->x(corner); });
    for (; each != blockers_.end() && outline_->x(*each) <= most; ++each) {
        ++tests_;
        if (mayBlock_[*each] && blocks(*each, a, ear, c, policy)) return false;
    }
    return true;
}

bool EarClipper::blocks(Corner corner, Corner a, Corner b, Corner c, EarPolicy policy) const {
    const std::uint32_t vertex = outline_->vertex(corner);
    // Where the outline touches itself, the angles at the two corners do not overlap.
    if (vertex == outline_->vertex(a) || vertex == outline_->vertex(b) || vertex == outline_->vertex(c)) return false;
    if (policy == EarPolicy::AnyEar) {
        return outline_->side(a, b, corner) >= 0 && outline_->side(b, c, corner) >= 0 &&
               outline_->side(c, a, corner) >= 0;
    }
    const double least = -kFlat * std::max(outline_->squaredDistance(a, b), outline_->squaredDistance(b, c));
    return outline_->doubledArea(a, b, corner) >= least && outline_->doubledArea(b, c, corner) >= least &&
           outline_->doubledArea(c, a, corner) >= least;
}

/// Whether the diagonal from a to c, which would cut off the ear b, begins and ends inside the outline.
bool EarClipper::isWithinCorners(Corner a, Corner c, Corner b) const {
    const Corner before = previous_[a], after = next_[c];
    const auto isSame = [&](Corner one, Corner other) { return outline_->vertex(one) == outline_->vertex(other); };
    const bool beginsInside =
        outline_->side(before, a, b) <= 0 || outline_->side(a, c, before) > 0 || isSame(before, c);
    const bool endsInside = outline_->side(b, c, after) <= 0 || outline_->side(c, after, a) > 0 || isSame(after, a);
    return beginsInside && endsInside;
}

bool EarClipper::turnsClearly(Corner corner) const {
    const Corner a = previous_[corner], c = next_[corner];
    const double size = std::max(outline_->squaredDistance(a, corner), outline_->squaredDistance(corner, c));
    return outline_->doubledArea(a, corner, c) > kFlat * size;
}

void EarClipper::remove(Corner corner) {
    const Corner a = previous_[corner], c = next_[corner];
    TACTOOTH_ASSERT(left_ > 0);
    TACTOOTH_ASSERT(next_[a] == corner && previous_[c] == corner);
    next_[a] = c;
    previous_[c] = a;
    const auto forget = [&](Corner each) {
        TACTOOTH_ASSERT(!mayBlock_[each] || liveBlockers_ > 0);
        if (mayBlock_[each]) --liveBlockers_;
        mayBlock_[each] = false;
    };
    forget(corner);
    --left_;
    for (const Corner each : {a, c}) {
        if (mayBlock_[each] && turnsClearly(each)) forget(each);
    }
    if (2 * liveBlockers_ < blockers_.size()) forgetBlockers();
}

/// A spike (an edge to a point and straight back) has no area, and its two edges cancel, so it is removed. Searches at
/// `corner` and behind it. Returns a remaining corner there.
EarClipper::Corner EarClipper::removeSpikes(Corner corner) {
    const auto isSpike = [&](Corner tip) { return outline_->vertex(previous_[tip]) == outline_->vertex(next_[tip]); };
    while (left_ >= 3) {
        const Corner tip = isSpike(corner) ? corner : next_[corner];
        if (!isSpike(tip)) break;
        corner = previous_[tip];
        remove(tip);
        remove(next_[corner]);
    }
    return corner;
}

void EarClipper::forgetBlockers() {
    std::erase_if(blockers_, [&](Corner corner) { return !mayBlock_[corner]; });
}

}  // namespace tactooth
