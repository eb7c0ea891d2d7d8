// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "session/model/session_model.h"

class QLabel;

namespace tactooth {

class ReplayBar;
class ReplaySource;
class ToothView;

/// The picture of a recording with its controls. It has a session of its own that never simulates: the tooth is there
/// for the camera only.
class ReplayPanel final : public QWidget {
    Q_OBJECT

public:
    /// `sound` outlives the panel; nothing is played on it.
    explicit ReplayPanel(SoundOutput& sound, QWidget* parent = nullptr);
    ~ReplayPanel() override;

    /// Shows another recording.
    void setSource(const ReplaySource& source);
    [[nodiscard]] ToothView& view() const { return *view_; }
    [[nodiscard]] ReplayBar& bar() const { return *bar_; }
    /// The handpieces as they are drawn; null until they are made.
    [[nodiscard]] HandpieceMeshes handpieces();

private:
    SessionModel model_;
    QLabel* sign_;
    ToothView* view_;
    ReplayBar* bar_;
};

}  // namespace tactooth
