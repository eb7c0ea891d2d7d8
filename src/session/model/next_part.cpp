// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/next_part.h"

#include <algorithm>

namespace tactooth {
namespace {

using namespace std::chrono_literals;

constexpr auto kFirstWait = 2s;
constexpr auto kLongestWait = 60s;
constexpr auto kOverdue = 3s;  // a hand rests more often than that, unless it cuts all the time

}  // namespace

void NextPart::reset() {
    trial_.cancel();
    wantedSince_.reset();
    possibleSince_.reset();
    wait_ = {};
    doneBefore_ = undoneBefore_ = 0;
}

void NextPart::wantNow() { wantedSince_ = possibleSince_ = Clock::now(); }

void NextPart::wantWhenWritable() {
    wantedSince_ = Clock::now();
    possibleSince_.reset();
    wait_ = std::clamp<Clock::duration>(2 * wait_, kFirstWait, kLongestWait);
    nextTrial_ = *wantedSince_ + wait_;
}

void NextPart::begun(const CutHistory& history) {
    wantedSince_.reset();
    possibleSince_.reset();
    doneBefore_ = history.done.size();
    undoneBefore_ = history.undone.size();
}

bool NextPart::isPossible(const RecordingFolder& folder, std::uint64_t bytes) {
    if (!wantedSince_ || possibleSince_) return wantedSince_.has_value();
    if (const auto tried = trial_.poll(); tried && *tried && **tried) possibleSince_ = Clock::now();
    if (possibleSince_ || trial_.isBusy() || Clock::now() < nextTrial_) return possibleSince_.has_value();
    nextTrial_ = Clock::now() + std::max<Clock::duration>(wait_, kFirstWait);
    trial_.start([folder, bytes]() -> Expected<bool> { return folder.hasRoomFor(bytes); });
    return false;
}

bool NextPart::isOverdue() const { return possibleSince_ && Clock::now() > *possibleSince_ + kOverdue; }

bool NextPart::canReplay(Edit edit, const CutHistory& history) const {
    if (edit == Edit::Undo) return history.done.size() > doneBefore_;
    return edit != Edit::Redo || history.undone.size() > undoneBefore_;
}

}  // namespace tactooth
