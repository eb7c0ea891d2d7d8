// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "app/gui/keys/key_table.h"
#include "app/gui/replay/replay_slider.h"

class QComboBox;
class QLabel;
class QMenu;
class QToolButton;

namespace tactooth {

class ReplayCursor;

/// The controls below the picture of a recording.
class ReplayBar final : public QWidget {
    Q_OBJECT

public:
    explicit ReplayBar(QWidget* parent = nullptr);

    /// Shows the cursor. `ready`: how much of the recording is there, s.
    void show(const ReplayCursor& cursor, double ready);
    /// `text`: what was last, or the comment here.
    void showNote(const QString& text);
    void setMarks(std::vector<ReplaySlider::Mark> marks) { slider_->setMarks(std::move(marks)); }
    [[nodiscard]] const std::vector<ReplaySlider::Mark>& marks() const { return slider_->marks(); }
    /// Whether another recording is shown as a ghost.
    void setCompares(bool compares);
    /// The list of comments; the user sees it when it opens.
    [[nodiscard]] QMenu& commentMenu() const { return *comments_; }

signals:
    void playToggled();
    void timeChosen(double time);
    void speedChosen(double speed);
    void stepped(int ticks);
    void nextWanted();
    void previousWanted();
    void compareToggled();
    void commentWanted();
    void leaveWanted();

private:
    QToolButton* addButton(const char* name, const QString& text, const QString& tip, std::optional<KeyId> key);
    void addSpeeds();
    void addComments();

    QToolButton* play_ = nullptr;
    ReplaySlider* slider_;
    QLabel* time_;
    QComboBox* speeds_;
    QLabel* note_;
    QToolButton* compare_ = nullptr;
    QMenu* comments_ = nullptr;
};

}  // namespace tactooth
