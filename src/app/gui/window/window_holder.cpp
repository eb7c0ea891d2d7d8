// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/window/window_holder.h"

#include <QApplication>

#include "app/gui/window/main_window.h"
#include "app/gui/window/window_setup.h"

namespace tactooth {

WindowHolder::WindowHolder(QApplication& application, SoundOutput& sound) : application_(application), sound_(sound) {}
WindowHolder::~WindowHolder() = default;

MainWindow& WindowHolder::open(const WindowSettings& settings) {
    applyLanguage(application_, QString::fromStdString(settings.language));
    window_ = std::make_unique<MainWindow>(sound_);
    connect(window_.get(), &MainWindow::graphicsFailed, this, &WindowHolder::graphicsFailed);
    connect(window_.get(), &MainWindow::languageChosen, this, &WindowHolder::openAnew, Qt::QueuedConnection);
    window_->apply(settings);
    return *window_;
}

void WindowHolder::openAnew() {
    WindowSettings settings = window_->settings();
    MainWindow::Work work = window_->handOver();
    if (work.bur && !work.bur->file.empty()) settings.bur.clear();
    const bool quits = QApplication::quitOnLastWindowClosed();
    QApplication::setQuitOnLastWindowClosed(false);
    window_.reset();
    open(settings);
    if (!work.tooth) window_->bringBuiltinTooth(kBuiltinTeeth.front());  // none has come yet
    window_->takeOver(std::move(work));
    window_->show();
    QApplication::setQuitOnLastWindowClosed(quits);
}

}  // namespace tactooth
