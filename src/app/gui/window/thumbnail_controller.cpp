// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/window/thumbnail_controller.h"

#include <filesystem>
#include <utility>

#include "app/gui/controllers/tooth_controller.h"
#include "app/gui/model/recent_file.h"
#include "app/gui/scene/tooth_view.h"
#include "session/recording/session_recording.h"

namespace tactooth {

ThumbnailController::ThumbnailController(SessionModel& model, ToothView& view, ToothController& teeth,
                                         std::function<Shown()> shown)
    : model_(model), view_(view), shown_(std::move(shown)) {
    connect(&teeth, &ToothController::fileOpened, this, &ThumbnailController::expect);
    connect(&teeth, &ToothController::loadingFailed, this, [this] { expected_.clear(); });
    connect(&teeth, &ToothController::loadingDeclined, this, [this] { expected_.clear(); });
    connect(&teeth, &ToothController::toothSaved, this, &ThumbnailController::keep);
    model_.setRecordingEnding([this]() -> SessionKeeper::Kept {
        return [store = store_, picture = newest_](const std::filesystem::path& file) {
            store.save(QString::fromStdString(file.string()), picture);
        };
    });
}

ThumbnailController::~ThumbnailController() { model_.setRecordingEnding(nullptr); }

void ThumbnailController::update() {
    if (view_.pictures() == seen_ || !view_.isVisible()) return;
    const Shown shown = shown_();
    if (shown == Shown::Loading || !view_.isAtRest()) return;
    seen_ = view_.pictures();
    // Small already: it is taken often, and kept for long.
    const QImage picture = view_.grabFramebuffer().scaled(ThumbnailStore::kSize, ThumbnailStore::kSize,
                                                          Qt::KeepAspectRatio, Qt::SmoothTransformation);
    if (shown == Shown::Session) newest_ = picture;
    const bool isRecording = std::filesystem::path(expected_.toStdString()).extension() == kSessionFileEnding;
    const bool isExpected = isRecording == (shown == Shown::Recording);
    if (!expected_.isEmpty() && isExpected) store_.save(std::exchange(expected_, QString()), picture);
}

void ThumbnailController::expect(const QString& file) {
    expected_ = RecentFile::fromText(file).files.front();
    seen_ = view_.pictures();  // that shows the file before
}

void ThumbnailController::keep(const QString& file) { store_.save(file, newest_); }

}  // namespace tactooth
