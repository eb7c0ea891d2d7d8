// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window_session.h"

#include <QApplication>
#include <QDialog>
#include <QElapsedTimer>
#include <QProgressBar>
#include <QSignalSpy>
#include <QSlider>
#include <QTimer>
#include <utility>

namespace tactooth::test {
namespace {

constexpr double kNear = 0.05;  // mm

}  // namespace

/// Where the main window is in front again after a dialog, as a window manager sees to it. Without one the X server
/// takes the focus away from everybody; Qt notices 0.4 s later, and then the window lets go of the pedal.
class WindowSession::Focus final : public QObject {
public:
    explicit Focus(const std::unique_ptr<MainWindow>& window) : window_(window) { qApp->installEventFilter(this); }
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Hide && qobject_cast<QDialog*>(watched) != nullptr && window_ != nullptr) {
            QTimer::singleShot(0, window_.get(), [window = window_.get()] {
                if (window->isVisible() && QApplication::activeModalWidget() == nullptr) window->activateWindow();
            });
        }
        return false;
    }

private:
    const std::unique_ptr<MainWindow>& window_;  // a test may put another one in its place
};

WindowSession::WindowSession() : focus_(std::make_unique<Focus>(window_)) {}
WindowSession::~WindowSession() = default;

void WindowSession::openWindow() {
    sound_ = std::make_unique<OpenAlOutput>();
    window_ = std::make_unique<MainWindow>(*sound_);
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth.front());
    window_->teeth().loadBur(*findBur("4"));
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get(), kPatience));
}

void WindowSession::openWindowWithSettings() {
    openWindow();
    window_->apply(window_->settings());
}

void WindowSession::waitForTooth() {
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isBusy() && window_->model().runner() != nullptr, kLoadPatience);
}

void WindowSession::key(Qt::Key which, Qt::KeyboardModifiers with) const {
    QApplication::setActiveWindow(window_.get());  // a bare X server has no window manager to do it
    QTest::keyClick(window_.get(), which, with);
}

void WindowSession::pressBurOn(const QPoint& place) const {
    const QPointF pixel = view().devicePixelRatioF() * QPointF(place);
    QTest::mouseMove(&view(), place + QPoint(1, 1));  // one that is there already would not move at all
    QTest::mouseMove(&view(), place);
    const auto isThere = [&] {
        MouseManipulator aimed = window_->model().manipulator();
        aimed.aim(view().viewport(), Vec2(pixel.x(), pixel.y()), *touchableSurface(window_->model()));
        const Vec3 goal = aimed.pose().position;
        return (goal - window_->model().manipulator().pose().position).norm() < kNear &&
               (goal - window_->model().log().newest().contact.proxy.position).norm() < kNear;
    };
    (void)QTest::qWaitFor(isThere, 10'000);
    QTest::mousePress(&view(), Qt::LeftButton, {}, place);
}

void WindowSession::liftBur(const QPoint& place) const {
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, place);
    const auto isClear = [&] {
        const Vec3 hand = window_->model().manipulator().pose().position;
        return window_->model().log().newest().contact.triangles == 0 &&
               (hand - window_->model().log().newest().contact.proxy.position).norm() < kNear;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isClear(), kPatience);
}

void WindowSession::waitForSteps(int steps) const {
    QSignalSpy stepped(&window_->loop(), &StepLoop::stepped);
    QTRY_VERIFY_WITH_TIMEOUT(stepped.count() >= steps, kPatience);
}

void WindowSession::waitForCarving() const {
    constexpr double kQuiet = 0.3;  // s of the simulation without a new surface: detached pieces fall after 0.1 s
    const LiveRunner* watched = nullptr;
    std::uint64_t updates = 0;
    double since = 0;
    const auto isQuiet = [&] {
        const LiveRunner* const runner = window_->model().runner();
        if (runner == nullptr) return false;
        const double now = window_->model().log().newest().time;
        const std::uint64_t newest = runner->feed().surfaceUpdates();
        if (std::exchange(watched, runner) != runner || std::exchange(updates, newest) != newest || now < since) {
            since = now;
        }
        return now > since + kQuiet;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isQuiet(), kPatience);
}

void WindowSession::waitForFiles() const { QTRY_VERIFY_WITH_TIMEOUT(!window_->isWriting(), kPatience); }

bool WindowSession::waitForQuietPicture() const {
    std::uint64_t last = view().pictures();
    QElapsedTimer unchanged;
    unchanged.start();
    return QTest::qWaitFor(
        [&] {
            if (view().pictures() != last || !view().isAtRest()) {
                last = view().pictures();
                unchanged.restart();
            }
            return unchanged.elapsed() > 1000;
        },
        kPatience);
}

void WindowSession::waitForRest() const {
    window_->model().setSpindle(window_->model().haptics().spindle);
    waitForSteps(2);
    const auto* busy = window_->findChild<QProgressBar*>("busy");  // it moves until the instruments are modelled
    QTRY_VERIFY_WITH_TIMEOUT(view().isAtRest() && window_->loop().isResting() && !busy->isVisible(), kPatience);
}

QString WindowSession::dismissMessage() const {
    auto* box = window_->findChild<QMessageBox*>();
    if (box == nullptr) return {};
    const QString text = box->text();
    delete box;
    return text;
}

QString WindowSession::messageAfterFiles() const {
    waitForFiles();
    return dismissMessage();
}

void WindowSession::answerUnsaved(QMessageBox::StandardButton answer) const {
    QMessageBox* const box = unsavedQuestion();
    if (box != nullptr) QTest::mouseClick(box->button(answer), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(unsavedQuestion() == nullptr, kPatience);
}

QPoint WindowSession::onCrown() const {
    constexpr double kBelow = 2;  // mm: within the edge of a front tooth, below the fissure of a molar
    const Box3 box = window_->model().tooth()->box();
    const Vec3 place(box.center().x(), box.center().y(), box.max().z() - kBelow);
    const Viewport picture = view().viewport();
    const auto pixel = project(picture.camera(), picture.size(), place);
    return (QPointF(pixel->x(), pixel->y()) / view().devicePixelRatioF()).toPoint();
}

bool WindowSession::waitWithPedal(const std::function<bool()>& hasHappened) {
    const auto* const pedal = window_->findChild<QSlider*>("pedal");
    return QTest::qWaitFor(
        [&] {
            if (pedal->value() == 0) QTest::keyPress(&view(), Qt::Key_Space);
            return hasHappened();
        },
        kPatience);
}

QString WindowSession::stateOfHand() const {
    const SessionModel& model = window_->model();
    const Tick& tick = model.log().newest();
    const MouseManipulator& hand = model.manipulator();
    const auto text = [](const Vec3& p) { return QString("(%1, %2, %3)").arg(p.x()).arg(p.y()).arg(p.z()); };
    return QString("removed %1 mm3, speed %2 rev/min, cutting %3, pressing %4, may cut %5, depth %6 mm, ")
               .arg(removed())
               .arg(tick.spindle.speedRpm)
               .arg(tick.input.cutting)
               .arg(hand.isPressing())
               .arg(hand.mayCut())
               .arg(tick.contact.depth) +
           QString("tool at %1, hand at %2, landing at %3, tick at %4 s")
               .arg(text(tick.contact.proxy.position), text(hand.pose().position),
                    hand.landing() ? text(*hand.landing()) : "none")
               .arg(tick.time);
}

void WindowSession::cutALittle() {
    const double before = removed();
    key(Qt::Key_C);
    view().setFocus();
    QVERIFY2(waitWithPedal([&] { return gauge("speedGauge") > 300; }), qPrintable(stateOfHand()));
    const QPoint place = onCrown();
    pressBurOn(place);
    QVERIFY2(waitWithPedal([&] { return removed() > before + 0.02; }), qPrintable(stateOfHand()));
    liftBur(place);
    QTest::keyRelease(&view(), Qt::Key_Space);
    key(Qt::Key_T);
    QTRY_VERIFY_WITH_TIMEOUT(gauge("speedGauge") < 1, kPatience);
    waitForCarving();
}

void WindowSession::closeWindow() {
    window_.reset();
    sound_.reset();
}

void WindowSession::loadMolar() {
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth.front());
    answerUnsaved(QMessageBox::Discard);
    QTRY_VERIFY_WITH_TIMEOUT(window_->windowTitle().contains("molar"), kLoadPatience);
    waitForTooth();
}

}  // namespace tactooth::test
