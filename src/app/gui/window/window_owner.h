// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <memory>

#include "app/gui/settings/window_settings.h"
#include "journal/codec/signing_key.h"

class QApplication;

namespace tactooth {

class LiveStream;
class MainWindow;
class SoundOutput;

/// Owns the program's window. When the user chooses another language, another window takes over the tooth with its
/// cuts, the bur, the view and all settings.
class WindowOwner final : public QObject {
    Q_OBJECT

public:
    /// Both outlive the owner.
    WindowOwner(QApplication& application, SoundOutput& sound);
    ~WindowOwner() override;

    /// Where the windows to come keep their recordings; empty (as without this call): nowhere.
    void setRecordings(const std::filesystem::path& folder) { recordings_ = folder; }
    /// The windows to come hold an examination, whose recordings this key signs.
    void setExamination(std::shared_ptr<const SigningKey> seal) { seal_ = std::move(seal); }
    /// The windows to come send each tick there; null (as without this call): nowhere.
    void setStream(std::shared_ptr<LiveStream> stream) { stream_ = std::move(stream); }
    /// Makes the window in the language of `settings`; it is not shown yet.
    MainWindow& open(const WindowSettings& settings);
    /// The window; another one after a change of the language.
    [[nodiscard]] MainWindow& window() { return *window_; }

signals:
    /// MainWindow::graphicsFailed.
    void graphicsFailed(const QString& sentence);

private:
    void reopen();

    QApplication& application_;
    SoundOutput& sound_;
    std::filesystem::path recordings_;
    std::shared_ptr<const SigningKey> seal_;
    std::shared_ptr<LiveStream> stream_;
    std::unique_ptr<MainWindow> window_;
};

}  // namespace tactooth
