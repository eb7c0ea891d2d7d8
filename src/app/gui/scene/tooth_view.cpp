// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/tooth_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/common/spin_blur.h"

namespace tactooth {
namespace {

constexpr int kRestMs = 400;        // without a change until the careful picture is drawn
constexpr int kSecondLasts = 4;     // pictures while things move, so that the small one hardly slows them
constexpr double kPressStep = 0.1;  // mm for one notch of the wheel
constexpr double kZoomStep = 0.88;  // for one notch, or one press of a key
constexpr double kKeyStep = 0.006;  // of the picture's height, for one press of an arrow key: 0.2 mm on a molar
constexpr double kKeyTurn = 6;      // times that when the tooth is turned

/// A twentieth of a pixel at a bur's rim; so the last creeping of a bur that runs down is not drawn.
constexpr double kSeenSpin = 0.003;  // rad
constexpr float kSeenBlur = 0.02F;   // of blurOf

bool samePose(const Pose& a, const Pose& b) {
    constexpr double kSeen = 0.002;  // mm, and rad times a tool's length: a twentieth of a pixel
    return (a.position - b.position).norm() < kSeen && a.rotation.angularDistance(b.rotation) < kSeen / 20;
}

}  // namespace

ToothView::ToothView(Workbench& bench, QWidget* parent)
    : QOpenGLWidget(parent), bench_(bench), secondFrame_(new SecondViewFrame(this)) {
    secondFrame_->hide();
    connect(secondFrame_, &SecondViewFrame::clicked, this, [this] { look(*second_); });
    setUpdateBehavior(PartialUpdate);  // the last picture stays
    setMinimumSize(320, 240);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setObjectName("toothView");
    rest_.setSingleShot(true);
    connect(&rest_, &QTimer::timeout, this, [this] {
        // On a slow computer the next quick picture may just be late: a careful one now would make it later still.
        careful_ = changeTo(bench_.contents(showsTurbine_, showsMirror_)) == PicturePace::Change::None;
        if (careful_) {
            redraw();
        } else {
            rest_.start(kRestMs);
        }
    });
    lookAsUsual();
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
    doneCurrent();
}

PictureSize ToothView::pictureSize() const {
    const double ratio = devicePixelRatioF();
    return {std::max(1, static_cast<int>(std::lround(width() * ratio))),
            std::max(1, static_cast<int>(std::lround(height() * ratio)))};
}

Vec2 ToothView::toPixel(const QPointF& position) const {
    return Vec2(position.x(), position.y()) * devicePixelRatioF();
}

void ToothView::report(const Error& error) {
    failed_ = true;
    emit failed(QString::fromStdString(error.message));
}

void ToothView::initializeGL() {
    // Called again whenever the widget gets a new context; nothing of the old one is of use then.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ToothView::forgetRenderer);
    isStale_ = true;
    Expected<Renderer> renderer = Renderer::create();
    if (renderer) {
        renderer_.emplace(std::move(*renderer));
        letSoftwareRendererGiveWay();
    } else {
        report(renderer.error());
    }
}

/// The picture has to be drawn again. What the desktop wants to have anew can be taken from the last one.
void ToothView::redraw() {
    isStale_ = true;
    update();
}

void ToothView::paintGL() {
    if (!renderer_ || failed_) return;
    SceneContents contents = bench_.contents(showsTurbine_, showsMirror_);
    if (!std::exchange(isStale_, false) && changeTo(contents) == PicturePace::Change::None) return;
    contents.camera = camera_.camera();
    drawn_ = contents;
    sinceDrawn_.start();
    const bool careful = std::exchange(careful_, false);
    const PicturePace::Change change = std::exchange(change_, PicturePace::Change::Motion);
    RenderSettings settings = kFine;
    if (!careful) {
        settings = pace_.isSmooth() && change == PicturePace::Change::Motion ? kSmooth : kQuick;
        settings.resolution = pace_.resolution(change);
        rest_.start(kRestMs);
    }
    Scene scene = sceneFor(contents);
    scene.second = secondPicture(careful);
    auto done = renderer_->render(scene, defaultFramebufferObject(), pictureSize(), settings);
    if (!done) report(done.error());
    context()->functions()->glFinish();  // a software renderer works after the last call, too
    if (!careful) pace_.drew(change, 1e-6 * static_cast<double>(sinceDrawn_.nsecsElapsed()));
    ++pictures_;
}

Scene ToothView::sceneFor(const SceneContents& contents) const {
    Scene scene = makeScene(contents);
    if (contents.tooth != nullptr && inspection_ != Inspection()) {
        inspect(scene, bench_.tooth()->piece->tooth(), inspection_);
    }
    constexpr double kEyesPerFocus = 1.0 / 30;  // eye distance by that of the tooth: easy to look at
    scene.stereo = {stereo_, camera_.distance(), kEyesPerFocus * camera_.distance()};
    return scene;
}

/// Not where there is nothing to be seen yet, and not for two eyes.
bool ToothView::drawsSecond() const { return second_ && bench_.tooth() && stereo_ == Stereo::Mode::Off; }

/// While things move it is not drawn as often as the large one.
std::optional<SecondView> ToothView::secondPicture(bool careful) {
    if (!drawsSecond()) return std::nullopt;
    const bool anew = careful || secondAge_ == 0;
    secondAge_ = anew ? 1 : (secondAge_ + 1) % kSecondLasts;
    return SecondView{crownFrom(*second_, bench_.mesialX(), bench_.tooth()->box()), anew};
}

PicturePace::Change ToothView::changeTo(const SceneContents& now) const {
    using enum PicturePace::Change;
    if (now.tooth != drawn_.tooth || now.tool.has_value() != drawn_.tool.has_value() ||
        now.mirror.has_value() != drawn_.mirror.has_value() || now.suction.has_value() != drawn_.suction.has_value() ||
        now.flying != drawn_.flying) {
        return Motion;
    }
    if (now.mirror && (now.mirror->mesh != drawn_.mirror->mesh || now.mirror->fog != drawn_.mirror->fog ||
                       now.mirror->drops != drawn_.mirror->drops)) {
        return Motion;
    }
    if (!now.tool) return None;
    if (now.tool->bur != drawn_.tool->bur || now.tool->turbine != drawn_.tool->turbine ||
        !samePose(now.tool->toolInTooth, drawn_.tool->toolInTooth)) {
        return Motion;
    }
    const float blur = blurOf(now.tool->speedRpm, now.tool->edge);
    if (std::abs(blur - blurOf(drawn_.tool->speedRpm, drawn_.tool->edge)) > kSeenBlur) return Spin;
    if (blur == 1 && now.tool->blurred != nullptr) return None;  // the same at every turn
    const double turned = std::remainder(now.tool->spin - drawn_.tool->spin, 2 * std::numbers::pi);
    return std::abs(turned) > kSeenSpin && (second_ || seesTip(now)) ? Spin : None;
}

/// Whether the bur may be in the picture.
bool ToothView::seesTip(const SceneContents& now) const {
    const PictureSize size = pictureSize();
    const auto pixel = project(camera_.camera(), size, now.tool->toolInTooth.position);
    constexpr double kAround = 0.3;  // of the picture's size: the shaft is still seen where the tip has left
    return pixel && std::abs(pixel->x() / size.width - 0.5) < 0.5 + kAround &&
           std::abs(pixel->y() / size.height - 0.5) < 0.5 + kAround;
}

void ToothView::refresh() {
    secondFrame_->setVisible(drawsSecond());  // a tooth has come
    const PicturePace::Change change = changeTo(bench_.contents(showsTurbine_, showsMirror_));
    if (sinceDrawn_.isValid() && !pace_.isDue(change, static_cast<double>(sinceDrawn_.elapsed()))) return;
    change_ = change;
    redraw();
}

void ToothView::fit() {
    if (!bench_.tooth()) return;
    // The crown is what is worked on; the roots may leave the picture, the head of the handpiece should not.
    constexpr double kAbove = 13;  // mm
    camera_.fit(crownBox(bench_.tooth()->box(), kAbove), pictureSize().aspect());
    redraw();
}

void ToothView::setEye(const OrbitCamera& eye) {
    camera_ = eye;
    redraw();
}

void ToothView::moveEye(const Vec2& way, bool shifts) {
    moveCamera(pictureSize().height * way, shifts ? Qt::MiddleButton : Qt::RightButton);
}

void ToothView::comeNearer(double factor) {
    const PictureSize size = pictureSize();
    camera_.zoom(factor, Vec2(size.width / 2.0, size.height / 2.0), size);
    redraw();
}

void ToothView::look(StandardView view) {
    camera_.look(view, bench_.mesialX());
    redraw();
}

void ToothView::centreOn(const Vec3& place) {
    camera_.centreOn(place);
    redraw();
}

void ToothView::lookAsUsual() {
    camera_.look(bench_.usualView());
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

void ToothView::setInspection(const Inspection& inspection, Stereo::Mode stereo) {
    inspection_ = inspection;
    stereo_ = stereo;
    secondFrame_->setVisible(drawsSecond());
    redraw();
}

void ToothView::setSecondView(std::optional<StandardView> view, const QString& title) {
    second_ = view;
    secondAge_ = 0;
    secondFrame_->setText(title);
    secondFrame_->setVisible(drawsSecond());
    redraw();
}

void ToothView::resizeEvent(QResizeEvent* event) {
    isStale_ = true;
    QOpenGLWidget::resizeEvent(event);
    secondFrame_->fitTo(pictureSize());
}

void ToothView::mousePressEvent(QMouseEvent* event) {
    mouse_ = toPixel(event->position());
    if (event->button() == Qt::LeftButton) bench_.hand().press(pointedPicture(), mouse_);
}

void ToothView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) bench_.hand().release();
}

void ToothView::moveCamera(const Vec2& way, Qt::MouseButtons buttons) {
    if (buttons & Qt::RightButton) {
        camera_.orbit(way, pictureSize());
    } else {
        camera_.pan(way, pictureSize());
    }
    redraw();
}

void ToothView::mouseMoveEvent(QMouseEvent* event) {
    const Vec2 now = toPixel(event->position());
    if (event->buttons() & (Qt::RightButton | Qt::MiddleButton)) {
        moveCamera(now - mouse_, event->buttons());
        mouse_ = now;
    } else {
        moveHand(now, event->modifiers());
    }
}

void ToothView::moveHand(const Vec2& to, Qt::KeyboardModifiers with) {
    const Vec2 way = to - mouse_;
    mouse_ = to;
    if (bench_.simulator() == nullptr) return;
    if (with & Qt::ShiftModifier) {
        bench_.hand().lean(pointedPicture(), way);
    } else if (bench_.hand().isPressing()) {
        bench_.hand().drag(pointedPicture(), to);
    } else {
        bench_.hand().aim(pointedPicture(), to, *bench_.felt());
    }
}

/// Arrows move the hand as the mouse does, with Ctrl the tooth turns; Enter presses as long as it is held.
bool ToothView::obeyKey(const QKeyEvent& key) {
    const std::array<std::pair<int, Vec2>, 4> ways = {{{Qt::Key_Left, Vec2(-1, 0)},
                                                       {Qt::Key_Right, Vec2(1, 0)},
                                                       {Qt::Key_Up, Vec2(0, -1)},
                                                       {Qt::Key_Down, Vec2(0, 1)}}};
    const PictureSize size = pictureSize();
    if (mouse_.x() < 0) mouse_ = Vec2(size.width / 2.0, size.height / 2.0);
    for (const auto& [code, way] : ways) {
        if (key.key() != code) continue;
        const Vec2 pixels = kKeyStep * size.height * way;
        if (key.modifiers() & Qt::ControlModifier) {
            moveCamera(kKeyTurn * pixels, Qt::RightButton);
        } else {
            moveHand(mouse_ + pixels, key.modifiers());
        }
        return true;
    }
    if (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter) {
        if (key.isAutoRepeat()) return true;
        bench_.hand().press(pointedPicture(), mouse_);
        isPressedByKey_ = true;
        return true;
    }
    if (key.key() != Qt::Key_Plus && key.key() != Qt::Key_Minus) return false;
    camera_.zoom(key.key() == Qt::Key_Plus ? kZoomStep : 1 / kZoomStep, mouse_, size);
    redraw();
    return true;
}

void ToothView::keyPressEvent(QKeyEvent* event) {
    if (!obeyKey(*event)) QOpenGLWidget::keyPressEvent(event);
}

void ToothView::keyReleaseEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!isEnter) return QOpenGLWidget::keyReleaseEvent(event);
    if (!event->isAutoRepeat()) endKeyPress();
}

/// A dialog in front gets the key's release.
void ToothView::focusOutEvent(QFocusEvent* event) {
    endKeyPress();
    QOpenGLWidget::focusOutEvent(event);
}

void ToothView::endKeyPress() {
    if (std::exchange(isPressedByKey_, false)) bench_.hand().release();
}

void ToothView::wheelEvent(QWheelEvent* event) {
    constexpr double kNotch = 120;  // eighths of a degree
    const double notches = event->angleDelta().y() / kNotch;
    if (event->modifiers() & Qt::ControlModifier) {
        camera_.zoom(std::pow(kZoomStep, notches), toPixel(event->position()), pictureSize());
        redraw();
    } else {
        bench_.hand().setPressDepth(bench_.hand().pressDepth() + kPressStep * notches);
        emit pressDepthChanged(bench_.hand().pressDepth());
    }
    event->accept();
}

}  // namespace tactooth
