// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>

#include "app/common/inspection.h"
#include "app/common/scene_builder.h"
#include "app/gui/input/viewport.h"
#include "app/gui/scene/frame_pacer.h"
#include "app/gui/scene/second_view_frame.h"
#include "session/model/session_model.h"
#include "view/camera/orbit_camera.h"
#include "view/render/renderer.h"

namespace tactooth {

/// The picture in the middle of the window, and the mouse in it. Draws when something has changed: quickly while things
/// move, as often as the computer has time for it, and once more with all care when they have come to rest.
class ToothView final : public QOpenGLWidget {
    Q_OBJECT

public:
    explicit ToothView(SessionModel& model, QWidget* parent = nullptr);
    ~ToothView() override;

    /// Draws again if what there is to see has changed and it is time for it.
    void refresh();
    /// Pictures drawn so far.
    [[nodiscard]] std::uint64_t pictures() const { return pictures_; }
    /// Whether the careful picture of a scene at rest is shown.
    [[nodiscard]] bool isAtRest() const;
    void fit();
    void setView(StandardView view);
    /// Shows this place of the tooth in the middle.
    void centreOn(const Vec3& place);
    /// How the picture is turned, shifted and enlarged.
    [[nodiscard]] const OrbitCamera& orbitCamera() const { return camera_; }
    void setOrbitCamera(const OrbitCamera& eye);
    /// Turns the tooth by `displacement`, in heights of the picture: half of one by 90 degrees. `shifts`: shifts it
    /// instead.
    void orbitBy(const Vec2& displacement, bool shifts);
    /// Leaves `factor` of the distance to the middle of the picture.
    void zoomBy(double factor);
    /// From buccal and above, as a dentist sees a lower tooth.
    void resetView();
    void setShowsTurbine(bool shows);
    void setShowsMirror(bool shows);
    /// How one looks into the tooth.
    void setInspection(const Inspection& inspection, Stereo::Mode stereo);
    /// A small picture from another side as well; none without a view.
    void setSecondView(std::optional<StandardView> view, const QString& title = {});
    /// What the mouse points into.
    [[nodiscard]] Viewport viewport() const { return {camera_.camera(), imageSize()}; }
    [[nodiscard]] Camera camera() const { return camera_.camera(); }
    [[nodiscard]] bool showsTurbine() const { return showsTurbine_; }
    [[nodiscard]] bool showsMirror() const { return showsMirror_; }

signals:
    /// The pressing depth was changed by the mouse wheel, mm.
    void pressDepthChanged(double depth);
    /// The graphics system cannot draw; a sentence.
    void failed(const QString& sentence);

protected:
    void initializeGL() override;
    void resizeEvent(QResizeEvent* event) override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    [[nodiscard]] ImageSize imageSize() const;
    [[nodiscard]] Vec2 toPixel(const QPointF& position) const;
    [[nodiscard]] FramePacer::Change changeTo(const SceneContents& now) const;
    [[nodiscard]] Scene sceneFor(const SceneContents& contents) const;
    [[nodiscard]] bool seesTip(const SceneContents& now) const;
    [[nodiscard]] bool drawsSecond() const;
    [[nodiscard]] std::optional<SecondView> secondPicture(bool careful);
    void moveCamera(const Vec2& displacement, Qt::MouseButtons buttons);
    void moveHand(const Vec2& to, Qt::KeyboardModifiers with);
    [[nodiscard]] bool obeyKey(const QKeyEvent& key);
    void endKeyPress();
    void report(const Error& error);
    void forgetRenderer();
    void redraw();

    SessionModel& model_;
    OrbitCamera camera_;
    std::optional<Renderer> renderer_;
    bool failed_ = false;
    bool showsTurbine_ = true;
    bool showsMirror_ = true;
    Inspection inspection_;
    Stereo::Mode stereo_ = Stereo::Mode::Off;
    std::optional<StandardView> second_;
    SecondViewFrame* secondFrame_;
    int secondAge_ = 0;  // pictures that it has been shown in
    SceneContents drawn_;
    bool careful_ = false;       // the next picture
    bool showsCareful_ = false;  // the last picture is careful
    bool isStale_ = true;        // the last picture: beside what changeTo sees
    FramePacer framePacer_;
    FramePacer::Change change_ = FramePacer::Change::Motion;  // that the next picture shows
    QTimer rest_;                                             // runs out when nothing has moved for a while
    QElapsedTimer sinceDrawn_;
    std::uint64_t pictures_ = 0;
    bool isPressedByKey_ = false;
    Vec2 mouse_ = Vec2::Constant(-1);  // or what the keys point at; outside until there is one
};

}  // namespace tactooth
