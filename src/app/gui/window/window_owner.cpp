// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/window/window_owner.h"

#include <QApplication>

#include "app/gui/settings/window_setup.h"
#include "app/gui/window/main_window.h"

namespace tactooth {

WindowOwner::WindowOwner(QApplication& application, SoundOutput& sound) : application_(application), sound_(sound) {}
WindowOwner::~WindowOwner() = default;

MainWindow& WindowOwner::open(const WindowSettings& settings) {
    applyLanguage(application_, QString::fromStdString(settings.language));
    window_ = std::make_unique<MainWindow>(sound_);
    connect(window_.get(), &MainWindow::graphicsFailed, this, &WindowOwner::graphicsFailed);
    connect(window_.get(), &MainWindow::languageChosen, this, &WindowOwner::reopen, Qt::QueuedConnection);
    window_->apply(settings);
    window_->model().streamTo(stream_);
    if (seal_ != nullptr) window_->examination().begin(seal_);
    window_->recordings().setFolder(recordings_);
    return *window_;
}

void WindowOwner::reopen() {
    WindowSettings settings = window_->settings();
    seal_ = window_->examination().seal();
    MainWindow::SessionState work = window_->releaseSession();
    if (work.bur && !work.bur->file.empty()) settings.bur.clear();
    const bool welcomes = window_->welcome().isOpen();
    const bool quits = QApplication::quitOnLastWindowClosed();
    QApplication::setQuitOnLastWindowClosed(false);
    window_.reset();
    open(settings);
    if (!work.tooth) window_->teeth().loadMouth({});  // no tooth had come yet
    window_->restoreSession(std::move(work));
    window_->show();
    if (welcomes) window_->welcome().open();
    QApplication::setQuitOnLastWindowClosed(quits);
}

}  // namespace tactooth
