// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/cut_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "session/simulation/pulp_distance.h"
#include "tooth/file/debris.h"

namespace tactooth {
namespace {

// Unspent work is kept up to this limit, so that a bur held on glass does not jump ahead when it meets caries. N*m;
// about 20 ms at 1 N and 300,000 rev/min.
constexpr double kKeptWork = 0.3;

// Longest feed of one update, mm: 20 mm/s at an update each 5 ms, faster than any hand. It keeps the search for the
// length of a step short where the device is far ahead of the bur.
constexpr double kLongestFeed = 0.1;

// The search for the length of a step begins where the work would suffice at the work for each mm of the last step,
// times this: that seldom falls by more from one update to the next.
constexpr double kLookAhead = 1.15;

// Share of the least work that a step was found to require: so much is saved. It also suffices for a slightly longer
// step.
constexpr double kStepMargin = 1.05;

// A step counts as the same if the bur begins this near, in voxels or rad, and its path has the same direction within
// some 10 degrees.
constexpr double kSamePlace = 1e-3;
constexpr double kSameDirection = 0.985;

// s without contact: the bur was lifted, and did not just cross a gap.
constexpr double kLifted = 0.1;

}  // namespace

std::shared_ptr<const Surface> surrounded(std::shared_ptr<const Surface> surface, const Surroundings& bodies) {
    if (bodies.empty()) return surface;
    auto all = std::make_shared<Surface>(*surface);
    all->patches.insert(all->patches.end(), bodies.begin(), bodies.end());
    return all;
}

CutModel::CutModel(std::shared_ptr<const LayeredTooth> tooth, double voxel)
    : tooth_(tooth), volume_(std::move(tooth), voxel), incremental_(volume_) {}

const std::shared_ptr<BrickPool>& CutModel::pool() {
    if (pool_ == nullptr) {
        pool_ = std::make_shared<BrickPool>(tooth_, volume_.lattice().spacing());
        volume_.setPool(pool_);
    }
    return pool_;
}

void CutModel::addRemoved(const CarveResult& carve) {
    for (std::size_t i = 0; i < kMaxMaterials; ++i) loss_.removed[i] += carve.removed[i];
    mayBeDetached_ = mayBeDetached_ || !carve.changed.empty();
    changed_.insert(changed_.end(), carve.changed.begin(), carve.changed.end());
}

/// Once a bur that cuts stands at `at`.
void CutModel::watchPulp(const CuttingTool& tool, const Pose& at) {
    if (loss_.nearPulp == 0 && isNearPulp(*tooth_, tool.envelope, at, kAtPulp)) loss_.nearPulp = 1;
}

MaterialVolumes CutModel::sweep(const CuttingTool& tool, const Pose& from, const Pose& to) {
    constexpr double kNoClearance = 0;  // exactly the swept volume is removed
    const CarveResult carve = volume_.carve(tool.envelope, from, to, kNoClearance);
    addRemoved(carve);
    if (!carve.changed.empty()) watchPulp(tool, to);
    return carve.removed;
}

/// The start of the next cut: the proxy, or the end of the last cut while the proxy is still on its path there.
Pose CutModel::startOf(const Tick& tick) const {
    if (!reached_) return tick.contact.proxy;
    const Vec3 left = reached_->position - tick.contact.proxy.position;
    const Vec3 toDevice = tick.input.device.position - tick.contact.proxy.position;
    const bool isMovingTo = left.norm() <= kLongestFeed && left.dot(toDevice) >= left.squaredNorm();
    return isMovingTo ? *reached_ : tick.contact.proxy;
}

/// The work that a cut may use now, N*m; nothing if there is none, or none new.
std::optional<double> CutModel::newWork(const Tick& tick) {
    updateContact(tick);
    const double work = tick.spindle.cutWork - workSpent_;
    const bool hasWorked = tick.spindle.cutWork > workSeen_;  // otherwise the work still does not suffice
    workSeen_ = tick.spindle.cutWork;
    if (tick.contact.triangles == 0 || !(work > 0)) {
        workSpent_ = tick.spindle.cutWork;
        reached_.reset();
        deferred_.reset();
        return std::nullopt;
    }
    return hasWorked ? std::optional(work) : std::nullopt;
}

/// A blade rolls off what it cannot take: where its path reaches firm tissue, it runs a little above.
bool CutModel::scrape(const CuttingTool& blade, const Tick& tick, const MaterialTable& materials) {
    const std::optional<double> work = newWork(tick);
    if (!work) return false;
    constexpr std::array kLifts = {0.0, 0.05, 0.1, 0.2, 0.4};  // mm off the tissue
    constexpr double kKept = 5e-4;                             // N*m: 0.5 N along 1 mm
    const Vec3 toDevice = tick.input.device.position - tick.contact.proxy.position;
    const double feed = std::min(toDevice.norm(), kLongestFeed);
    if (!(feed > 0)) return false;
    for (const double lift : kLifts) {
        const Pose start{tick.contact.proxy.position + lift * tick.contact.normal, tick.contact.proxy.rotation};
        const Pose goal{start.position + feed * toDevice.normalized(), start.rotation};
        const FeedResult result = feedBur(volume_, blade.envelope, start, goal, *work, materials, blade.sharpness);
        if (!std::isfinite(result.requiredWork)) continue;
        workSpent_ = std::max(workSpent_ + result.work,
                              tick.spindle.cutWork - std::max(kKept, kStepMargin * result.requiredWork));
        addRemoved(result.carve);
        const bool changed = !changed_.empty();
        if (changed) watchPulp(blade, between(start, goal, result.fraction));
        refreshSurface();
        return changed;
    }
    workSpent_ = tick.spindle.cutWork;
    return false;
}

bool CutModel::feed(const CuttingTool& tool, const Tick& tick, const MaterialTable& materials) {
    const std::optional<double> available = newWork(tick);
    if (!available) return false;
    const double work = *available;
    const Pose start = startOf(tick);
    const double toDevice = (tick.input.device.position - start.position).norm();
    const double feed = std::min(toDevice, kLongestFeed);
    const Pose goal = between(start, tick.input.device, toDevice > kLongestFeed ? kLongestFeed / toDevice : 1);
    if (isDeferred(start, goal, work)) return false;
    const double enough = enoughLength(work) / feed;
    const FeedResult result = feedBur(volume_, tool.envelope, start, goal, work, materials, tool.sharpness, enough);
    keepWorkOf(result, start, goal);
    reached_ = between(start, goal, result.fraction);
    // A broad bur in hard enamel must save work for its smallest step, which depends on the clearance of the cut.
    const double kept =
        std::isfinite(result.requiredWork) ? std::max(kKeptWork, kStepMargin * result.requiredWork) : kKeptWork;
    workSpent_ = std::max(workSpent_ + result.work, tick.spindle.cutWork - kept);
    addRemoved(result.carve);
    const bool changed = !changed_.empty();
    if (changed) watchPulp(tool, *reached_);
    refreshSurface();
    return changed;
}

/// Whether the same step was found to require more work than there is. A search would find nothing.
bool CutModel::isDeferred(const Pose& start, const Pose& goal, double work) const {
    if (!deferred_ || deferred_->edits != volume_.edits() || work >= deferred_->requiredWork) return false;
    const double near = kSamePlace * volume_.lattice().spacing();
    const Vec3 path = goal.position - start.position;
    return (start.position - deferred_->start.position).norm() <= near &&
           start.rotation.angularDistance(deferred_->start.rotation) <= kSamePlace &&
           path.dot(deferred_->path) > kSameDirection * path.norm() * deferred_->path.norm();
}

/// A length that is likely to need more than this work, mm. A step of the sweep shorter than a voxel requires no less.
double CutModel::enoughLength(double work) const {
    const double voxel = volume_.lattice().spacing();
    return lastWork_ ? std::max(kLookAhead * work / *lastWork_, voxel) : voxel;
}

void CutModel::keepWorkOf(const FeedResult& result, const Pose& start, const Pose& goal) {
    deferred_.reset();
    const Vec3 path = goal.position - start.position;
    const double length = result.fraction * path.norm();
    if (length > 0) lastWork_ = result.work / length;
    if (result.fraction == 0 && result.requiredWork > 0 && std::isfinite(result.requiredWork))
        deferred_ = DeferredStep{start, path, result.requiredWork, volume_.edits()};
}

/// Time starts anew with each simulation of the model.
void CutModel::updateContact(const Tick& tick) {
    if (tick.contact.triangles > 0 || tick.time < touchedAt_) touchedAt_ = tick.time;
}

bool CutModel::removeDetachedPieces(const Tick& tick) {
    updateContact(tick);
    return tick.time > touchedAt_ + kLifted && removeDetachedPieces();
}

bool CutModel::removeDetachedPieces() {
    if (!std::exchange(mayBeDetached_, false)) return false;
    const std::uint64_t revision = surface()->revision;
    refreshSurface();
    const DetachedPieces pieces = volume_.removeDetached();
    addFallen(pieces.carve);
    loss_.pieces += static_cast<std::size_t>(
        std::ranges::count_if(pieces.volumes, [](double volume) { return volume >= kVisiblePiece; }));
    addFallen(volume_.removeDebris(nodesBesideDebris(*surface(), volume_.bricks(), volume_.lattice())));
    mayBeDetached_ = false;  // a fallen piece sets no other one free
    return surface()->revision != revision;
}

void CutModel::addFallen(const CarveResult& carve) {
    for (std::size_t i = 0; i < kMaxMaterials; ++i) loss_.detached[i] += carve.removed[i];
    addRemoved(carve);
    refreshSurface();
}

void CutModel::refreshSurface() {
    if (changed_.empty()) return;
    incremental_.update(volume_, merged(std::move(changed_)));
    changed_.clear();
    loss_.beside = incremental_.lostAdjacent();
}

void CutModel::adopt(const std::map<BrickKey, CutField>& fields, const MaterialVolumes& removed) {
    changed_ = volume_.adopt(fields);
    loss_ = {.removed = removed};
    refreshSurface();
}

void CutModel::reopen() {
    refreshSurface();
    volume_.mark();  // the step under way ends: what comes is no part of it
    followSteps();
    incremental_ = IncrementalSurface(volume_, surface()->revision + 1);  // as it sums the volumes, its order matters
    for (const BrickKey& key : volume_.cutBricks()) changed_.push_back(ChangedBrick::all(key));
    loss_ = {.removed = loss_.removed, .detached = loss_.detached, .nearPulp = loss_.nearPulp};
    refreshSurface();
    reached_.reset();
    deferred_.reset();
    lastWork_.reset();
    mayBeDetached_ = false;
    touchedAt_ = workSpent_ = workSeen_ = 0;
}

void CutModel::replace(const std::map<BrickKey, CutField>& fields, const ToothLoss& loss) {
    steps_ = {};
    reached_.reset();
    const std::vector<ChangedBrick> changed = volume_.replace(fields);
    changed_.insert(changed_.end(), changed.begin(), changed.end());
    refreshSurface();
    loss_ = loss;
}

void CutModel::followSteps() { steps_.follow(volume_.undoable(), volume_.redoable()); }

void CutModel::markStep(const CutStep& step) {
    followSteps();
    volume_.mark();
    followSteps();  // the volume may have forgotten old steps
    steps_.mark(step, loss_);
}

void CutModel::mark(double time) { markStep({CutStep::Kind::Stroke, time}); }

CutHistory CutModel::history() {
    followSteps();
    return steps_.history();
}

bool CutModel::undo() {
    followSteps();
    if (volume_.undoable() == 0) return false;
    restore(volume_.undo(), steps_.undo(loss_));
    return true;
}

bool CutModel::redo() {
    followSteps();
    if (volume_.redoable() == 0) return false;
    restore(volume_.redo(), steps_.redo(loss_));
    return true;
}

void CutModel::restore(const std::vector<ChangedBrick>& changed, const ToothLoss& loss) {
    reached_.reset();
    changed_.insert(changed_.end(), changed.begin(), changed.end());
    loss_ = loss;
    refreshSurface();
}

bool CutModel::reset(double time) {
    reached_.reset();
    lastWork_.reset();
    mayBeDetached_ = false;
    if (volume_.cutBricks().empty()) return false;
    markStep({CutStep::Kind::Reset, time});
    volume_.reset();
    incremental_.reset();
    loss_ = {};
    changed_.clear();
    markStep({CutStep::Kind::Stroke, time});
    return true;
}

}  // namespace tactooth
