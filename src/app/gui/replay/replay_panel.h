// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/gui/replay/replay_picture.h"
#include "view/camera/orbit_camera.h"

class QLabel;

namespace tactooth {

class ReplayBar;

/// The picture of a recording with its controls. Another recording may have a picture beside it; both look from the
/// same place.
class ReplayPanel final : public QWidget {
    Q_OBJECT

public:
    /// `sound` outlives the panel; nothing is played on it.
    explicit ReplayPanel(SoundOutput& sound, QWidget* parent = nullptr);

    /// Shows another recording.
    void setSource(const ReplaySource& source);
    /// Adds the picture of another recording beside the first, with its camera.
    void addOther(const ReplaySource& source);
    void removeOther();
    /// Both pictures look from where one of them has been turned to.
    void coupleCameras();

    [[nodiscard]] ReplayPicture& first() const { return *first_; }
    /// Null: there is no other one.
    [[nodiscard]] ReplayPicture* other() const { return other_; }
    [[nodiscard]] ToothView& view() const { return first_->view(); }
    [[nodiscard]] ReplayBar& bar() const { return *bar_; }

private:
    SoundOutput& sound_;
    QLabel* sign_;
    ReplayPicture* first_;
    ReplayPicture* other_ = nullptr;
    QWidget* pictures_;
    ReplayBar* bar_;
    OrbitCamera shared_;  // of both pictures
};

}  // namespace tactooth
