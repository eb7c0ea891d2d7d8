// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace tactooth {

class DrivePanel;
class GuidedTour;

/// Sees the keys and the mouse of the whole program. The pedal key works the pedal wherever the focus is, unless a
/// dialog is in front. A key or a click ends the guided tour.
class InputFilter final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the filter.
    InputFilter(QWidget& window, DrivePanel& drive, GuidedTour& tour);

    void setPedalKey(Qt::Key key) { pedalKey_ = key; }
    [[nodiscard]] Qt::Key pedalKey() const { return pedalKey_; }

signals:
    /// The user has moved or pressed something.
    void userActive();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget& window_;
    DrivePanel& drive_;
    GuidedTour& tour_;
    Qt::Key pedalKey_ = Qt::Key_Space;
};

}  // namespace tactooth
