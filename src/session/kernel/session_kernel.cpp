// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/session_kernel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/util/assert.h"

// As in Box2D's recorder and in "record and replay" debuggers, only what is not determined is recorded: the inputs, and
// the order of what the threads exchange. The kernel takes the place of the threads and of the queues between them.

namespace tactooth {

SessionKernel::SessionKernel(std::shared_ptr<CutModel> model) : model_(std::move(model)) {
    TACTOOTH_ASSERT(model_ != nullptr);
}

SessionKernel::~SessionKernel() = default;

bool SessionKernel::apply(const SessionEvent& event) {
    if (!servo_ && !std::holds_alternative<BeginEvent>(event)) return false;
    return std::visit([this](const auto& one) { return on(one); }, event);
}

bool SessionKernel::on(const BeginEvent& event) {
    if (event.instrument.shape == nullptr) return false;
    pending_.clear();
    retired_.clear();
    published_.clear();
    ticks_.clear();
    carvedAt_ = listedAt_ = 0;
    received_ = 0;
    newest_ = {};
    begin_ = event;
    sweep_.reset();
    servo_.emplace(event.instrument, model_->contactSurface(), event.settings, event.placement);
    carving_.emplace(model_, event.instrument, event.settings.materials);
    listing_.emplace(servo_->tool(), servo_->surface(), event.placement);
    return true;
}

bool SessionKernel::on(const ForceEvent& event) {
    servo_->setForce(event.parameters);
    return true;
}

/// The servo thread takes so many surfaces; false if fewer were sent.
bool SessionKernel::take(std::uint32_t count) {
    if (count > pending_.size()) return false;
    for (std::uint32_t i = 0; i < count; ++i) {
        servo_->take(*pending_.front());
        retired_.push_back(pending_.front());
        pending_.pop_front();
    }
    return true;
}

bool SessionKernel::on(const TickEvent& event) {
    if (event.input.elapsed < 0 || !take(event.taken)) return false;
    newest_ = servo_->step(event.input);
    ticks_.push_back(newest_);
    return true;
}

/// Null if there is no such tick, or if it was forgotten. Number 0 is what a thread sees before the first tick.
const Tick* SessionKernel::tickAt(TickNumber number) const {
    static const Tick none;
    if (number == 0) return &none;
    if (ticks_.empty() || number < ticks_.front().number || number > ticks_.back().number) return nullptr;
    return &ticks_[number - ticks_.front().number];
}

/// A stage may see the same tick again, but none before it.
void SessionKernel::forgetOldTicks() {
    const TickNumber oldest = std::min(carvedAt_, listedAt_);
    while (!ticks_.empty() && ticks_.front().number < oldest) ticks_.pop_front();
}

/// What a stage does is known; the record shows whether it was the same.
bool SessionKernel::publish(bool changed, bool recorded) {
    if (changed) published_.push_back({model_->contactSurface(), model_->reached()});
    return changed == recorded;
}

bool SessionKernel::on(const CarveEvent& event) {
    const Tick* const tick = tickAt(event.tick);
    if (tick == nullptr || event.tick < carvedAt_ || !canCut()) return false;
    carvedAt_ = event.tick;
    const bool changed = carving_->carve(*tick);
    forgetOldTicks();
    return publish(changed, event.published);
}

bool SessionKernel::on(const EditEvent& event) {
    return canCut() && publish(carving_->edit(event.edit), event.published);
}

bool SessionKernel::canCut() const { return begin_->instrument.carves() && !model_->tooth().isTouchOnly(); }

/// Between two such ticks all turns see the newest one.
bool SessionKernel::on(const ExactTickEvent& event) {
    const OperatorInput& input = event.input;
    if (!(event.elapsed >= 0) || !std::isfinite(event.elapsed) || !std::isfinite(event.time)) return false;
    if (!take(event.taken)) return false;
    if (event.swept) {
        if (!canCut() || begin_->instrument.hand || !isRigid(input.deviceInTooth)) return false;
        const BeginEvent& begin = *begin_;
        if (!sweep_) {
            sweep_.emplace(model_, begin.instrument.cutting, begin.settings.spindle.freeSpeedRpm,
                           begin.settings.materials);
        }
        newest_ = sweep_->step(input.deviceInTooth, event.time, event.elapsed, input.pedal > 0);
    } else {
        newest_ = servo_->step(input, event.elapsed);
    }
    ticks_.assign(1, newest_);
    return true;
}

bool SessionKernel::on(const FinishEvent& event) {
    return canCut() && publish(carving_->finish(event.dropsPieces), event.published);
}

bool SessionKernel::on(const TickHashEvent& event) { return event.hash == tickHash(); }

bool SessionKernel::on(const CarvingHashEvent& event) { return event.hash == carving_->hash(); }

bool SessionKernel::on(const ListEvent& event) {
    const Tick* const tick = tickAt(event.tick);
    if (tick == nullptr || event.tick < listedAt_ || event.recycled > retired_.size()) return false;
    listedAt_ = event.tick;
    std::optional<CarvedSurface> cut;
    if (event.surface != 0) {
        if (event.surface <= received_ || event.surface > received_ + published_.size()) return false;
        for (; received_ < event.surface; ++received_) {  // the thread sees the newest one only
            cut = std::move(published_.front());
            published_.pop_front();
        }
    }
    for (std::uint32_t i = 0; i < event.recycled; ++i) {
        listing_->recycle(retired_.front());
        retired_.pop_front();
    }
    HapticSurface* const made = listing_->turn(*tick, std::move(cut));
    if (event.sent && made == nullptr) return false;
    if (event.sent) {
        listing_->sent();
        pending_.push_back(made);
    } else if (made != nullptr) {
        listing_->recycle(made);
    }
    forgetOldTicks();
    return true;
}

}  // namespace tactooth
