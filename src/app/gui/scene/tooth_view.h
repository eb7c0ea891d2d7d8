// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>
#include <functional>

#include "app/common/inspection.h"
#include "app/common/scene_builder.h"
#include "app/gui/input/mirror_mouse.h"
#include "app/gui/input/picture_pixels.h"
#include "app/gui/input/viewport.h"
#include "app/gui/keys/key_map.h"
#include "app/gui/scene/aim_overlay.h"
#include "app/gui/scene/frame_pacer.h"
#include "app/gui/scene/measure_tool.h"
#include "app/gui/scene/outline_overlay.h"
#include "app/gui/scene/rest_fade.h"
#include "app/gui/scene/second_view_frame.h"
#include "app/gui/scene/surface_tool.h"
#include "app/gui/scene/view_overlays.h"
#include "app/gui/settings/window_settings.h"
#include "haptics/latency_histogram.h"
#include "session/hands/hand_pointer.h"
#include "session/model/session_model.h"
#include "view/camera/orbit_camera.h"
#include "view/render/renderer.h"

namespace tactooth {

/// The picture in the middle of the window, with the mouse in it. It draws when something has changed: quickly and as
/// often as the machine can while things move, and once with full quality when they have come to rest. That picture
/// takes the place of the last quick one gradually.
class ToothView final : public QOpenGLWidget {
    Q_OBJECT

public:
    explicit ToothView(SessionModel& model, QWidget* parent = nullptr);
    ~ToothView() override;

    /// Shows these contents in place of the session: `contents` gives them for each picture. The mouse and the keys
    /// then move only the camera.
    using ContentsSource = std::function<SceneContents(bool withTurbine, bool withMirror)>;
    void setContents(ContentsSource contents);
    /// Draws again if the scene has changed and the next picture is due.
    void refresh();
    /// Number of pictures drawn so far.
    [[nodiscard]] std::uint64_t pictures() const { return pictures_; }
    /// How long each picture took to draw while something moved, us.
    [[nodiscard]] const LatencyHistogram& pictureTimes() const { return pictureTimes_; }
    /// Whether it shows the full-quality picture of a scene at rest.
    [[nodiscard]] bool isAtRest() const;
    /// Whether it shows something between that picture and the last one before it.
    [[nodiscard]] bool isFading() const { return fade_.isRunning(); }
    /// Lets the crown fill the picture.
    void fit();
    void setView(StandardView view);
    void setView(OrbitCamera::Direction direction);
    /// Brings this place of the tooth to the middle.
    void centreOn(const Vec3& place);
    /// Direction, centre and distance of the view.
    [[nodiscard]] const OrbitCamera& orbitCamera() const { return camera_; }
    void setOrbitCamera(const OrbitCamera& eye);
    /// Turns the tooth by `displacement`, in picture heights: half a height turns it by 90 degrees. `shifts`: shifts it
    /// instead.
    void orbitBy(const Vec2& displacement, bool shifts);
    /// Multiplies the distance to the centre of the picture by `factor`.
    void zoomBy(double factor);
    /// From where a dentist sees the tooth, with the whole crown and the head of the handpiece in the picture: turns,
    /// shifts and zooms back.
    void resetView();
    /// The same; where a dentist sees the tooth by the mirror only, the mirror is held so that it shows the chewing
    /// surface.
    void takeDentistView();
    void setShowsTurbine(bool shows);
    void setShowsMirror(bool shows);
    /// Holds the mirror where it shows the bur from behind; a sentence says so if there is no such place.
    void placeMirror();
    /// The mirror waits again beside the tooth.
    void parkMirror();
    /// The same, and it is shown even if it was hidden.
    void takeParkedMirror();
    /// The mirror moves in the picture by `displacement`, in picture heights; or it tilts to there.
    void moveMirror(const Vec2& displacement, bool tilts);
    /// The mirror comes nearer to the eye, mm.
    void approachMirror(double distance);
    /// Landing ring, plumb line and numbers at the tip.
    void setShowsAim(bool shows);
    [[nodiscard]] const AimOverlay& aim() const { return *aim_; }
    /// Off: the aim shows no numbers and no warnings.
    void setShowsNumbers(bool shows) { aim_->setShowsNumbers(shows); }
    [[nodiscard]] MeasureTool& measureTool() { return *measure_; }
    /// Marks the place that the tip of the bur in a device's hand points at, while somebody measures.
    void markAtTip();
    /// Somebody measures: clicks mark places.
    [[nodiscard]] bool isMeasuring() const;
    /// Gives the mouse on the tooth to `tool`, and hides the instruments meanwhile; null: the mouse holds the bur
    /// again. `tool` stays there until then.
    void setSurfaceTool(SurfaceTool* tool);
    /// The lines on the tooth.
    [[nodiscard]] OutlineOverlay& outlines() const { return *outlines_; }
    /// What helps to find one's way in the picture.
    void setAids(const ViewAids& aids);
    /// The keys that work in the picture.
    void setKeys(const PictureKeys& keys) { keys_ = keys; }
    /// Section, transparency, colours and ghost, and stereo.
    void setInspection(const Inspection& inspection, Stereo::Mode stereo);
    /// Shows a small picture from another side too; none: no small picture.
    void setSecondView(std::optional<StandardView> view, const QString& title = {});
    /// The picture for the mouse manipulator.
    [[nodiscard]] Viewport viewport() const { return {camera_.camera(), pictureSize(*this)}; }
    [[nodiscard]] Camera camera() const { return camera_.camera(); }
    [[nodiscard]] bool showsTurbine() const { return showsTurbine_; }
    [[nodiscard]] bool showsMirror() const { return showsMirror_; }
    /// How the picture shows the mirror, for a recording.
    [[nodiscard]] MirrorSight mirrorSight() const;

signals:
    /// The mouse wheel has changed the press depth, mm.
    void pressDepthChanged(double depth);
    /// The mouse wheel has changed the depth at which a press ends, mm.
    void depthChanged(double depth);
    /// The user has taken or placed the mirror, which may be hidden.
    void mirrorUsed();
    /// The eye looks from this place at the chair, by the mirror or directly.
    void dentistViewTaken(int clock, bool byMirror);
    /// No place of the mirror shows the bur, or the chewing surface.
    void mirrorNotPlaced();
    /// The graphics system cannot draw; a sentence.
    void failed(const QString& sentence);

protected:
    bool event(QEvent* event) override;
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
    [[nodiscard]] SceneContents contents() const;
    void addGlass(SceneContents& contents) const;
    [[nodiscard]] FramePacer::Change changeTo(const SceneContents& now) const;
    [[nodiscard]] Scene sceneFor(const SceneContents& contents) const;
    [[nodiscard]] bool seesTip(const SceneContents& now) const;
    [[nodiscard]] bool drawsSecond() const;
    [[nodiscard]] bool magnifies() const;
    void showOverlays();
    [[nodiscard]] std::optional<SecondView> secondPicture() const;
    void moveCamera(const Vec2& displacement, Qt::MouseButtons buttons);
    void moveHand(const Vec2& to, Qt::KeyboardModifiers with);
    void showAim();
    void showAimOnTooth();
    void showCursor();
    /// The mirror's glass in the picture; none where it is not shown.
    [[nodiscard]] std::optional<MirrorDisc> glass() const;
    void pressHand();
    void pointHand(const Vec2& displacement, bool leans);
    [[nodiscard]] std::optional<Ray> alongTip() const;
    /// That takes the mouse now; null: none does.
    [[nodiscard]] SurfaceTool* activeTool() const;
    void followLines();
    void turnWheel(double notches, Qt::KeyboardModifiers with);
    [[nodiscard]] bool obeyKey(const QKeyEvent& key);
    [[nodiscard]] bool isPress(const QKeyEvent& key) const;
    void endKeyPress();
    void holdMirror(bool held);
    void report(const Error& error);
    void forgetRenderer();
    void redraw();
    [[nodiscard]] Expected<void> draw(const Scene& scene, const RenderSettings& settings, bool fades);

    SessionModel& model_;
    MirrorMouse mirrorMouse_;
    HandPointer pointer_;
    ContentsSource contents_;  // null: the session
    OrbitCamera camera_;
    std::optional<Renderer> renderer_;
    bool failed_ = false;
    bool showsTurbine_ = true;
    bool showsMirror_ = true;
    ViewAids aids_;
    Inspection inspection_;
    Stereo::Mode stereo_ = Stereo::Mode::Off;
    std::optional<StandardView> second_;
    AimOverlay* aim_;
    MeasureTool* measure_;
    OutlineOverlay* outlines_;
    SurfaceTool* tool_ = nullptr;
    Vec2 rightPress_ = Vec2::Zero();  // where the right button went down
    bool showsAim_ = true;
    SecondViewFrame* secondFrame_;
    ViewOverlays* overlays_;
    SceneContents drawn_;
    bool careful_ = false;       // the next picture is drawn with full quality
    bool showsCareful_ = false;  // the last picture has full quality
    bool isStale_ = true;        // something that changeTo does not see has changed
    FramePacer framePacer_;
    FramePacer::Change change_ = FramePacer::Change::Motion;  // of the next picture
    QTimer rest_;                                             // runs out when nothing has moved for kRestMs
    QElapsedTimer sinceDrawn_;
    std::uint64_t pictures_ = 0;
    LatencyHistogram pictureTimes_;
    PictureKeys keys_;
    bool isPressedByKey_ = false;
    Vec2 mouse_ =
        Vec2::Constant(-1);  // position of the mouse or of the arrow keys, pixels; outside until the first event
    RestFade fade_;
};

}  // namespace tactooth
