// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "session/model/session_model.h"

class QLabel;

namespace tactooth {

class ElidedLabel;
class ReplaySource;
class ToothView;

/// The picture of a recording. Beside another one it has a line below: the colour of its curves in the plots, its name,
/// its time, and a button that closes it. It has a session of its own that never simulates: the tooth is there for the
/// camera only.
class ReplayPicture final : public QWidget {
    Q_OBJECT

public:
    /// `sound` outlives the picture; nothing is played on it. `name`: the object name of the view; those of the other
    /// parts begin with it. `colour`: of its curves.
    ReplayPicture(SoundOutput& sound, const QString& name, const QColor& colour, QWidget* parent = nullptr);
    ~ReplayPicture() override;

    /// Shows another recording, from where its picture was first looked at, or from where a dentist sees it.
    void setSource(const ReplaySource& source);
    void setShowsCaption(bool shows);
    /// Time of the recording that is shown, and its length, s.
    void showTime(double time, double length);
    [[nodiscard]] ToothView& view() const { return *view_; }
    /// The handpieces as they are drawn; null until they are made.
    [[nodiscard]] HandpieceMeshes handpieces();

signals:
    void closeWanted();

private:
    [[nodiscard]] QWidget* makeCaption(const QString& name, const QColor& colour);

    SessionModel model_;
    ToothView* view_;
    ElidedLabel* title_;
    QLabel* clock_;
    QWidget* caption_;
};

}  // namespace tactooth
