// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/tooth_view.h"

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/gui/scene/quick_settings.h"
#include "app/gui/scene/scene_change.h"
#include "app/gui/scene/session_scene.h"
#include "app/gui/scene/view_cube.h"

namespace tactooth {
namespace {

constexpr int kRestMs = 400;                               // without a change until the full-quality picture is drawn
constexpr double kPressStep = 0.1;                         // mm for one notch of the wheel
constexpr double kDepthStep = 0.1, kFineDepthStep = 0.02;  // mm for one notch

}  // namespace

ToothView::ToothView(SessionModel& model, QWidget* parent)
    : QOpenGLWidget(parent),
      model_(model),
      mirrorMouse_(model),
      aim_(new AimOverlay(this)),
      measure_(new MeasureTool(*this)),
      outlines_(new OutlineOverlay(this)),
      secondFrame_(new SecondViewFrame(this)),
      overlays_(new ViewOverlays(*this)),
      fade_([this] { update(); }) {
    secondFrame_->hide();
    connect(&overlays_->cube(), &ViewCube::viewChosen, this, qOverload<StandardView>(&ToothView::setView));
    connect(&overlays_->cube(), &ViewCube::apicalChosen, this, [this] {
        constexpr double kRightAngle = std::numbers::pi / 2;
        camera_.setView({kRightAngle, -kRightAngle});
        redraw();
    });
    connect(secondFrame_, &SecondViewFrame::clicked, this, [this] { setView(*second_); });
    setUpdateBehavior(PartialUpdate);  // keeps the last picture
    setMinimumSize(320, 240);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    showCursor();
    setObjectName("toothView");
    rest_.setSingleShot(true);
    connect(&rest_, &QTimer::timeout, this, [this] {
        // On a slow machine the next quick picture may just be late. A full-quality picture now would delay it more.
        if (changeTo(contents()) == FramePacer::Change::None) {
            redraw();
            careful_ = true;
        } else {
            rest_.start(kRestMs);
        }
    });
    resetView();
}

ToothView::~ToothView() {
    forgetRenderer();
    // The base class destroys the context after this object has ceased to be a ToothView.
    if (context() != nullptr) disconnect(context(), nullptr, this, nullptr);
}

void ToothView::forgetRenderer() {
    if (!renderer_) return;
    makeCurrent();
    renderer_.reset();
    fade_.forget();
    doneCurrent();
}

SceneContents ToothView::contents() const {
    SceneContents contents = contents_ ? contents_(showsTurbine_, showsMirror_)
                                       : sceneContents(model_, showsTurbine_, showsMirror_ && tool_ == nullptr);
    if (!contents_ && tool_ != nullptr) contents.tool.reset();  // nothing in front of the tooth
    if (!aids_.softTissues) contents.softTissues.clear();
    return contents;
}

/// Adds what the glass needs to know about the hand.
void ToothView::addGlass(SceneContents& contents) const {
    contents.glass = aids_.glass;
    const bool byMouse = !contents_ && model_.devices().first() == nullptr;
    if (byMouse && contents.tool) contents.tool->heading = model_.manipulator().pressDirection();
}

void ToothView::setContents(ContentsSource contents) {
    contents_ = std::move(contents);
    showCursor();
    redraw();
}

void ToothView::report(const Error& error) {
    failed_ = true;
    emit failed(QString::fromStdString(error.message()));
}

void ToothView::initializeGL() {
    // Qt calls it again for each new context. All objects of the old context are lost.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ToothView::forgetRenderer);
    isStale_ = true;
    careful_ = false;  // there is no last picture yet
    Expected<Renderer> renderer = Renderer::create();
    if (renderer) {
        renderer_.emplace(std::move(*renderer));
        lowerSoftwareRendererPriority();
    } else {
        report(renderer.error());
    }
}

/// Draws the picture again. When only the desktop needs it, Qt reuses the last one.
void ToothView::redraw() {
    isStale_ = true;
    careful_ = false;  // what wants another picture has moved
    overlays_->follow(camera_, pictureSize(*this), model_.mesialX());
    followLines();
    update();
}

void ToothView::followLines() {
    if (measure_->isOn()) measure_->follow(viewport());
    outlines_->follow(viewport(), glass());
}

void ToothView::paintGL() {
    if (!renderer_ || failed_) return;
    SceneContents now = contents();
    const bool isSame = changeTo(now) == FramePacer::Change::None;
    if (!std::exchange(isStale_, false) && isSame) return fade_.draw(defaultFramebufferObject());
    fade_.stop();
    now.camera = camera_.camera();
    addGlass(now);
    drawn_ = now;
    sinceDrawn_.start();
    const bool careful = std::exchange(careful_, false) && isSame;
    showsCareful_ = careful;
    const FramePacer::Change change = std::exchange(change_, FramePacer::Change::Motion);
    RenderSettings settings = kFine;
    if (!careful) {
        settings = framePacer_.isSmooth() && change == FramePacer::Change::Motion ? kSmooth : quickSettings();
        settings.resolution = framePacer_.resolution(change);
        rest_.start(kRestMs);
    }
    Scene scene = sceneFor(now);
    scene.second = secondPicture();
    if (magnifies() && now.tool) scene.magnified = now.tool->toolInTooth * Vec3(0, 0, 0.5 * now.tool->head.length);
    if (const auto done = draw(scene, settings, careful); !done) report(done.error());
    context()->functions()->glFinish();  // a software renderer still works after the last call
    const double milliseconds = 1e-6 * static_cast<double>(sinceDrawn_.nsecsElapsed());
    if (!careful) {
        framePacer_.recordFrame(change, milliseconds);
        pictureTimes_.add(1000 * milliseconds);
    }
    ++pictures_;
}

/// `fades`: the picture comes gradually, in place of the one that is shown.
Expected<void> ToothView::draw(const Scene& scene, const RenderSettings& settings, bool fades) {
    const unsigned shown = defaultFramebufferObject();
    const ImageSize size = pictureSize(*this);
    if (fades) {
        if (auto done = fade_.prepare(shown, size); !done) return done;
    }
    if (auto done = renderer_->render(scene, shown, size, settings); !done || !fades) return done;
    return fade_.start(shown);
}

bool ToothView::isAtRest() const {
    return showsCareful_ && !isFading() && !isStale_ && changeTo(contents()) == FramePacer::Change::None;
}

Scene ToothView::sceneFor(const SceneContents& contents) const {
    Scene scene = makeScene(contents);
    if (contents.tooth != nullptr && inspection_ != Inspection()) {
        applyInspection(scene, model_.tooth()->piece->tooth(), inspection_);
    }
    constexpr double kEyesPerFocus =
        1.0 / 30;  // eye distance as a share of the distance of the tooth: comfortable to look at
    scene.stereo = {stereo_, camera_.distance(), kEyesPerFocus * camera_.distance()};
    return scene;
}

/// Not without a tooth, and not in stereo.
bool ToothView::drawsSecond() const { return second_ && model_.tooth() && stereo_ == Stereo::Mode::Off; }

std::optional<SecondView> ToothView::secondPicture() const {
    if (!drawsSecond()) return std::nullopt;
    return SecondView{crownCamera(*second_, model_.mesialX(), model_.tooth()->box())};
}

FramePacer::Change ToothView::changeTo(const SceneContents& now) const {
    return sceneChange(now, drawn_, [&] { return second_ || seesTip(now); });
}

/// Whether the bur may be visible in the picture.
bool ToothView::seesTip(const SceneContents& now) const {
    const ImageSize size = pictureSize(*this);
    const auto pixel = project(camera_.camera(), size, now.tool->toolInTooth.position);
    constexpr double kAround = 0.3;  // of the picture's size: the shaft may be visible when the tip is outside
    return pixel && std::abs(pixel->x() / size.width - 0.5) < 0.5 + kAround &&
           std::abs(pixel->y() / size.height - 0.5) < 0.5 + kAround;
}

void ToothView::refresh() {
    showOverlays();  // a tooth may have come
    showAim();
    if (const auto ray = isMeasuring() ? alongTip() : std::nullopt) {
        measure_->point(*touchableSurface(model_), viewport(), *ray);
    }
    const FramePacer::Change change = changeTo(contents());
    if (sinceDrawn_.isValid() && !framePacer_.isDue(change, static_cast<double>(sinceDrawn_.elapsed()))) return;
    change_ = change;
    redraw();
}

void ToothView::fit() {
    if (!model_.tooth()) return;
    constexpr double kFilled = 0.8;  // of the picture: the rim shows what is around
    camera_.fill(crownCorners(contents().tooth.get(), model_.tooth()->box()), kFilled, pictureSize(*this).aspect());
    redraw();
}

void ToothView::setOrbitCamera(const OrbitCamera& eye) {
    camera_ = eye;
    redraw();
}

void ToothView::orbitBy(const Vec2& displacement, bool shifts) {
    moveCamera(pictureSize(*this).height * displacement, shifts ? Qt::MiddleButton : Qt::RightButton);
}

void ToothView::zoomBy(double factor) {
    const ImageSize size = pictureSize(*this);
    camera_.zoom(factor, Vec2(size.width / 2.0, size.height / 2.0), size);
    redraw();
}

void ToothView::setView(StandardView view) {
    camera_.setView(view, model_.mesialX());
    redraw();
}

void ToothView::setView(OrbitCamera::Direction direction) {
    camera_.setView(direction);
    redraw();
}

void ToothView::centreOn(const Vec3& place) {
    camera_.centreOn(place);
    redraw();
}

void ToothView::resetView() {
    camera_.setView(defaultView(model_));
    // The user works on the crown. The roots may be outside the picture, the head of the handpiece should not.
    constexpr double kAbove = 13;  // mm
    if (model_.tooth()) camera_.fit(crownBox(model_.tooth()->box(), kAbove), pictureSize(*this).aspect());
    redraw();
}

void ToothView::setShowsTurbine(bool shows) {
    showsTurbine_ = shows;
    redraw();
}

void ToothView::setShowsMirror(bool shows) {
    showsMirror_ = shows;
    redraw();
}

void ToothView::setShowsAim(bool shows) {
    showsAim_ = shows;
    showAim();
}

/// Not in the pictures of a recording.
bool ToothView::isMeasuring() const { return measure_->isOn() && !contents_ && model_.runner() != nullptr; }

/// Not in stereo, where a flat line would lie in front of everything.
void ToothView::showAim() {
    if (!showsAim_ || contents_ || isMeasuring() || tool_ != nullptr || stereo_ != Stereo::Mode::Off)
        aim_->showNothing();
    else
        showAimOnTooth();
    showCursor();
}

void ToothView::showAimOnTooth() {
    const std::optional<MirrorDisc> mirror = glass();
    aim_->show(model_, viewport(),
               mirror ? std::optional(AimOverlay::Mirror{*mirror, pointer_.isInMirror()}) : std::nullopt);
}

/// The landing ring takes the cursor's place where both are together: over the tooth, unless the bur cannot get there.
void ToothView::showCursor() {
    Qt::CursorShape shape = contents_ ? Qt::OpenHandCursor : Qt::CrossCursor;
    const QPointF mouse = QPointF(mouse_.x(), mouse_.y()) / devicePixelRatioF();
    if (!contents_ && aim_->isRingAt(mouse) && model_.manipulator().landing()) shape = Qt::BlankCursor;
    if (mirrorMouse_.isHeld()) shape = Qt::SizeAllCursor;
    if (cursor().shape() != shape) setCursor(shape);
}

void ToothView::setAids(const ViewAids& aids) {
    if (aids == std::exchange(aids_, aids)) return;
    showOverlays();
    redraw();
}

/// Not without an instrument, and not in stereo.
bool ToothView::magnifies() const {
    return aids_.magnifier && (contents_ || (model_.runner() != nullptr && tool_ == nullptr)) &&
           stereo_ == Stereo::Mode::Off;
}

void ToothView::showOverlays() {
    secondFrame_->setVisible(drawsSecond());
    overlays_->choose(aids_, magnifies());
    const auto& distances = inspection_.distances;
    overlays_->showLegend(distances ? std::optional(distances->scale) : std::nullopt,
                          inspection_.ghost != nullptr && !inspection_.ghost->empty());
}

void ToothView::setInspection(const Inspection& inspection, Stereo::Mode stereo) {
    inspection_ = inspection;
    stereo_ = stereo;
    showOverlays();
    redraw();
}

void ToothView::setSecondView(std::optional<StandardView> view, const QString& title) {
    second_ = view;
    secondFrame_->setText(title);
    showOverlays();
    redraw();
}

void ToothView::resizeEvent(QResizeEvent* event) {
    isStale_ = true;
    careful_ = false;  // the last picture is lost
    QOpenGLWidget::resizeEvent(event);
    secondFrame_->fitTo(pictureSize(*this));
    aim_->setGeometry(rect());
    outlines_->setGeometry(rect());
    overlays_->follow(camera_, pictureSize(*this), model_.mesialX());
    followLines();
}

void ToothView::setSurfaceTool(SurfaceTool* tool) {
    tool_ = tool;
    model_.releaseHand();
    showAim();
    redraw();
}

SurfaceTool* ToothView::activeTool() const { return !contents_ && model_.runner() != nullptr ? tool_ : nullptr; }

void ToothView::mousePressEvent(QMouseEvent* event) {
    mouse_ = pixelAt(*this, event->position());
    if (event->button() == Qt::RightButton) rightPress_ = mouse_;
    if (event->button() != Qt::LeftButton) return;
    if (SurfaceTool* tool = activeTool()) return tool->press(*touchableSurface(model_), viewport(), mouse_);
    if (isMeasuring())
        return measure_->pick(*touchableSurface(model_), model_.tooth()->piece->tooth(), viewport(), mouse_);
    if (!contents_ && !mirrorMouse_.isHeld()) pressHand();
}

void ToothView::mouseReleaseEvent(QMouseEvent* event) {
    if (SurfaceTool* tool = activeTool()) {
        constexpr double kClick = 4;  // pixels: a mouse that has moved farther has turned the tooth
        const Vec2 now = pixelAt(*this, event->position());
        if (event->button() == Qt::LeftButton) tool->release();
        const bool isClick = (now - rightPress_).norm() <= kClick * devicePixelRatioF();
        if (event->button() == Qt::RightButton && isClick) tool->clickRight(viewport(), now);
    }
    if (event->button() == Qt::LeftButton) model_.releaseHand();
}

void ToothView::moveCamera(const Vec2& displacement, Qt::MouseButtons buttons) {
    if (buttons & Qt::RightButton) {
        camera_.orbit(displacement, pictureSize(*this));
    } else {
        camera_.pan(displacement, pictureSize(*this));
    }
    redraw();
}

void ToothView::mouseMoveEvent(QMouseEvent* event) {
    const Vec2 now = pixelAt(*this, event->position());
    const bool turnsByLeft = contents_ && (event->buttons() & Qt::LeftButton) != 0;
    if (turnsByLeft || (event->buttons() & (Qt::RightButton | Qt::MiddleButton))) {
        moveCamera(now - mouse_, turnsByLeft ? Qt::MouseButtons(Qt::RightButton) : event->buttons());
        mouse_ = now;
    } else {
        moveHand(now, event->modifiers());
    }
}

void ToothView::moveHand(const Vec2& to, Qt::KeyboardModifiers with) {
    const Vec2 from = std::exchange(mouse_, to);
    const Vec2 displacement = to - from;
    if (model_.runner() == nullptr) return;
    if (SurfaceTool* tool = activeTool()) {
        tool->move(*touchableSurface(model_), viewport(), to);
    } else if (isMeasuring() && !mirrorMouse_.isHeld()) {
        measure_->point(*touchableSurface(model_), viewport(), to);
    } else if (mirrorMouse_.isHeld()) {
        mirrorMouse_.move(viewport(), from, to, (with & keys_.lean) != 0);
    } else {
        pointHand(displacement, (with & keys_.lean) != 0);
    }
}

/// A dialog in front receives the key's release.
void ToothView::focusOutEvent(QFocusEvent* event) {
    endKeyPress();
    holdMirror(false);
    QOpenGLWidget::focusOutEvent(event);
}

void ToothView::endKeyPress() {
    if (std::exchange(isPressedByKey_, false)) model_.releaseHand();
}

void ToothView::wheelEvent(QWheelEvent* event) {
    const double notches = notchesOf(*event);
    if (mirrorMouse_.isHeld()) {
        approachMirror(kMirrorStep * notches);
    } else if (contents_ || (event->modifiers() & keys_.zoom)) {
        camera_.zoom(std::pow(kZoomStep, notches), pixelAt(*this, event->position()), pictureSize(*this));
        redraw();
    } else {
        turnWheel(notches, event->modifiers());
    }
    event->accept();
}

/// The depth at which the bur stops, or, where nothing stops it, how far the hand presses.
void ToothView::turnWheel(double notches, Qt::KeyboardModifiers with) {
    MouseManipulator& hand = model_.manipulator();
    if (hand.pressMode() == PressMode::Depth) {
        const double step = with & keys_.fineDepth ? kFineDepthStep : kDepthStep;
        hand.depthControl().setDepth(hand.depthControl().depth() + step * notches);
        emit depthChanged(hand.depthControl().depth());
    } else {
        hand.setPressDepth(hand.pressDepth() + kPressStep * notches);
        emit pressDepthChanged(hand.pressDepth());
    }
}

}  // namespace tactooth
