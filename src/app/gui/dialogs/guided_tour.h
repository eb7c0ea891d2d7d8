// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <vector>

#include "app/gui/input/viewport.h"
#include "session/model/session_model.h"

namespace tactooth {

class DrillBar;
class DrivePanel;
class ToothView;

/// The demonstration in the window. It steers the bur as the mouse does: over the tooth, on it, into it, and undoes the
/// cut. In each step a sentence explains how the user does the same. A click or a key ends it.
class GuidedTour final : public QObject {
    Q_OBJECT

public:
    GuidedTour(SessionModel& model, ToothView& view, DrillBar& drill, DrivePanel& drive, QObject* parent);

    void start();
    void stop();
    [[nodiscard]] bool isRunning() const { return timer_.isActive(); }

signals:
    void stepExplained(const QString& sentence);
    void ended();

private:
    struct Step {
        double seconds;
        QString sentence;
        void (GuidedTour::*begin)();
        bool strokes;  ///< the bur moves to and fro
    };
    void advance();
    void beginStep();
    void aim();
    void touch();
    void lift();
    void cut();
    void undo();
    void lookPastTheHandpiece();
    [[nodiscard]] Viewport picture() const;
    /// The place of the surface `aside` mm distal of the middle of the occlusal surface.
    [[nodiscard]] Vec3 placeAt(double aside) const;
    /// The pixel to point at for it. The middle of the picture if that place is behind the camera.
    [[nodiscard]] Vec2 pixelAt(double aside) const;

    SessionModel& model_;
    ToothView& view_;
    DrillBar& drill_;
    DrivePanel& drive_;
    QTimer timer_;
    std::vector<Step> steps_;
    std::size_t step_ = 0;
    double time_ = 0;  // of the step, s
};

}  // namespace tactooth
