// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "app/gui/keys/key_table.h"
#include "app/gui/replay/replay_slider.h"

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QMenu;
class QToolButton;

namespace tactooth {

class ElidedLabel;
class ReplayCursor;

/// The controls below the picture of a recording.
class ReplayBar final : public QWidget {
    Q_OBJECT

public:
    explicit ReplayBar(QWidget* parent = nullptr);

    void show(const ReplayCursor& cursor);
    /// `text`: what was last, or the comment here.
    void showNote(const QString& text);
    void setMarks(std::vector<ReplaySlider::Mark> marks) { slider_->setMarks(std::move(marks)); }
    [[nodiscard]] const std::vector<ReplaySlider::Mark>& marks() const { return slider_->marks(); }
    /// Shows that another recording is open, named so, and how much later it begins, s; an empty name: none is.
    void showOther(const QString& name, double shift);
    /// The button for this action of the window.
    void addSideBySide(QAction& action);
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
    /// The other recording should begin so much later, s.
    void shiftChosen(double shift);
    void alignWanted();
    void commentWanted();
    void leaveWanted();

private:
    QToolButton* addButton(const char* name, const QString& text, const QString& tip, std::optional<KeyId> key);
    void addSpeeds();
    void addComments();
    [[nodiscard]] QWidget* makeOtherRow();

    QToolButton* play_ = nullptr;
    ReplaySlider* slider_;
    QLabel* time_;
    QComboBox* speeds_;
    QLabel* note_;
    QToolButton* compare_ = nullptr;
    QMenu* comments_ = nullptr;
    QWidget* otherRow_;
    ElidedLabel* otherName_ = nullptr;
    QDoubleSpinBox* shift_ = nullptr;  // s
};

}  // namespace tactooth
