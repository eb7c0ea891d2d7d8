// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_comparison.h"

#include <utility>

#include "app/gui/controllers/file_dialogs.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/keys/key_binding.h"

namespace tactooth {

ReplayComparison::ReplayComparison(WindowMessages& messages, FileDialogs& files)
    : messages_(messages), files_(files), action_(tr("S&ide by side…")) {
    action_.setObjectName("replaySideBySide");
    action_.setIconText(tr("Side by side…"));
    action_.setCheckable(true);
    bindKey(action_, KeyId::ReplaySideBySide,
            tr("Shows another recording in a picture of its own beside this one; once more, and it is as before (%1)"));
    action_.setStatusTip(tr("Shows another recording beside this one, or no longer"));
    setLineIcon(action_, "side-by-side");
    connect(&action_, &QAction::triggered, this, &ReplayComparison::toggleSideBySide);
    showState();
}

void ReplayComparison::setFirst(std::shared_ptr<const SessionTrack> first) {
    first_ = std::move(first);
    close();
}

void ReplayComparison::open(const QString& file, Mode mode) {
    close();
    mode_ = mode;
    wasGhost_ = false;
    files_.enterFolderOf(file);
    opening_.start([path = std::filesystem::path(file.toStdString())] { return ReplaySource::open(path); });
}

void ReplayComparison::ask(Mode mode) {
    showState();  // a button has checked itself, but nothing is there yet
    files_.open(tr("Compare with another recording"), tr("Recorded sessions (*.ttsession);;All files (*)"),
                [this, mode](const QString& file) {
                    if (first_ == nullptr) return;
                    usualMode_ = mode;
                    open(file, mode);
                });
}

void ReplayComparison::toggle() { source_ != nullptr ? close() : ask(usualMode_); }

void ReplayComparison::toggleSideBySide() {
    if (source_ == nullptr) return ask(Mode::SideBySide);
    usualMode_ = isSideBySide() ? Mode::Ghost : Mode::SideBySide;
    if (isSideBySide() && !wasGhost_) return close();
    wasGhost_ = isGhost();
    mode_ = usualMode_;
    showState();
}

void ReplayComparison::close() {
    opening_.cancel();
    (void)release();
}

std::shared_ptr<ReplaySource> ReplayComparison::release() {
    std::shared_ptr<ReplaySource> released = std::exchange(source_, nullptr);
    firstTouch_.reset();
    otherTouch_.reset();
    shift_ = 0;
    showState();
    return released;
}

void ReplayComparison::poll() {
    if (auto opened = opening_.poll(); opened && first_ != nullptr) {
        if (*opened) {
            source_ = std::move(**opened);
            align();
        } else {
            messages_.showError(opened->error());
            showState();
        }
    }
    followFirstTouch();
}

void ReplayComparison::align() {
    if (source_ == nullptr) return;
    firstTouch_.emplace(first_);
    otherTouch_.emplace(source_->track());
    shift_ = 0;  // until the touches are known
    showState();
    followFirstTouch();
}

/// Without a touch in one of them there is nothing to align.
void ReplayComparison::followFirstTouch() {
    if (!firstTouch_ || !otherTouch_) return;
    const bool isFirstKnown = firstTouch_->search(), isOtherKnown = otherTouch_->search();
    if (!isFirstKnown || !isOtherKnown) return;
    const auto first = std::exchange(firstTouch_, std::nullopt)->time();
    const auto other = std::exchange(otherTouch_, std::nullopt)->time();
    if (!first || !other) return messages_.setHint(tr("A recording has no touch: both begin at the same moment."));
    shift_ = *first - *other;
    messages_.setHint(tr("Both recordings touch the tooth first at the same moment."));
    showState();
}

void ReplayComparison::setShift(double shift) {
    if (source_ == nullptr || shift == shift_) return;
    firstTouch_.reset();  // the user knows better
    otherTouch_.reset();
    shift_ = shift;
    showState();
}

void ReplayComparison::showState() {
    action_.setEnabled(first_ != nullptr);
    action_.setChecked(isSideBySide());
    emit changed();
}

}  // namespace tactooth
