// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/stepwise_session.h"

#include <utility>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kHashPeriod = 1;  // s

}  // namespace

StepwiseSession::StepwiseSession(std::shared_ptr<CutModel> model, const BeginEvent& begin, EventSink sink)
    : model_(std::move(model)),
      begin_(begin),
      sink_(std::move(sink)),
      servo_(begin.instrument, model_->contactSurface(), begin.settings, begin.placement),
      carving_(model_, begin.instrument, begin.settings.materials),
      listing_(servo_.tool(), servo_.surface(), begin.placement) {
    report(begin_);
}

void StepwiseSession::report(const SessionEvent& event) const {
    if (sink_) sink_(event);
}

void StepwiseSession::reportHashes() {
    report(TickHashEvent{sweep_ ? sweep_->hash() : servo_.hash()});
    report(CarvingHashEvent{carving_.hash()});
}

Tick StepwiseSession::step(const OperatorInput& input, double elapsed, double time) {
    TACTOOTH_ASSERT(!sweep_);
    TACTOOTH_ASSERT(elapsed >= 0);
    const std::uint32_t taken = pending_ != nullptr ? 1 : 0;
    if (pending_ != nullptr) {
        servo_.take(*pending_);
        retired_ = std::exchange(pending_, nullptr);
    }
    newest_ = servo_.step(input, elapsed);
    report(ExactTickEvent{input, elapsed, time, /*swept=*/false, taken});
    if (newest_.time >= nextHash_) {
        nextHash_ = newest_.time + kHashPeriod;
        reportHashes();
    }
    return newest_;
}

bool StepwiseSession::carve() {
    const bool changed = carving_.carve(newest_);
    published_ += changed ? 1 : 0;
    report(CarveEvent{newest_.number, changed});
    return changed;
}

void StepwiseSession::list() {
    TACTOOTH_ASSERT(pending_ == nullptr);
    const std::uint32_t recycled = retired_ != nullptr ? 1 : 0;
    if (retired_ != nullptr) listing_.recycle(std::exchange(retired_, nullptr));
    std::optional<CarvedSurface> cut;
    const bool isNew = published_ > listed_;
    if (isNew) cut = CarvedSurface{model_->contactSurface(), model_->reached()};
    listed_ = published_;
    pending_ = listing_.turn(newest_, std::move(cut));
    if (pending_ != nullptr) listing_.sent();
    report(ListEvent{newest_.number, isNew ? published_ : 0, recycled, pending_ != nullptr});
}

Tick StepwiseSession::sweep(const Pose& tool, double elapsed, double time, bool spins) {
    TACTOOTH_ASSERT(newest_.number == 0 || sweep_);
    if (!sweep_) {
        sweep_.emplace(model_, begin_.instrument.cutting, begin_.settings.spindle.freeSpeedRpm,
                       begin_.settings.materials);
    }
    newest_ = sweep_->step(tool, time, elapsed, spins);
    report(ExactTickEvent{{tool, spins ? 1.0 : 0.0, true}, elapsed, time, /*swept=*/true, 0});
    return newest_;
}

void StepwiseSession::finish(bool dropsPieces) {
    const bool changed = carving_.finish(dropsPieces);
    published_ += changed ? 1 : 0;
    report(FinishEvent{dropsPieces, changed});
    reportHashes();
}

}  // namespace tactooth
