// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/gamepad_navigation.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QTextEdit>
#include <QToolBar>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/gui/scene/tooth_view.h"

namespace tactooth {
namespace {

constexpr double kFirstRepeat = 0.4;     // s until a held arrow repeats for the first time,
constexpr double kNextRepeat = 0.1;      // and between its repetitions
constexpr double kOrbitSpeed = 1.0 / 3;  // picture heights a second: half of one turns the tooth by 90 degrees
constexpr double kNearer = 0.5;          // factor of the distance for one second
constexpr double kMirrorApproach = 8;    // mm/s

constexpr std::array kArrows = {std::pair{PadButton::Up, Qt::Key_Up}, std::pair{PadButton::Down, Qt::Key_Down},
                                std::pair{PadButton::Left, Qt::Key_Left}, std::pair{PadButton::Right, Qt::Key_Right}};

std::optional<Qt::Key> arrowKeyOf(PadButton button) {
    const auto* const found = std::ranges::find(kArrows, button, &std::pair<PadButton, Qt::Key>::first);
    return found == kArrows.end() ? std::nullopt : std::optional(found->second);
}

/// Posts the key to the event loop: its effect may close the window.
void post(QWidget& to, Qt::Key key) {
    for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
        QCoreApplication::postEvent(&to, new QKeyEvent(type, key, Qt::NoModifier));
    }
}

/// Clicks a button directly: Space is the pedal key, and Return leaves a dialog.
void activate(QWidget& widget) {
    if (auto* button = qobject_cast<QAbstractButton*>(&widget)) return button->animateClick();
    if (auto* box = qobject_cast<QComboBox*>(&widget)) return box->showPopup();
    post(widget, Qt::Key_Return);
}

/// The arrow key that changes the value of `control` in this direction; controls differ in it.
Qt::Key valueKey(const QWidget& control, bool more) {
    if (qobject_cast<const QAbstractSpinBox*>(&control) != nullptr) return more ? Qt::Key_Up : Qt::Key_Down;
    const bool isList = qobject_cast<const QComboBox*>(&control) != nullptr ||
                        qobject_cast<const QAbstractItemView*>(&control) != nullptr ||
                        qobject_cast<const QTextEdit*>(&control) != nullptr;
    if (isList) return more ? Qt::Key_Down : Qt::Key_Up;
    return more ? Qt::Key_Right : Qt::Key_Left;
}

bool isControl(const QWidget& widget, const QWidget& panel) {
    return (widget.focusPolicy() & Qt::TabFocus) != 0 && widget.focusProxy() == nullptr && widget.isEnabled() &&
           widget.isVisibleTo(&panel);
}

/// Controls in the order of the Tab key.
std::vector<QWidget*> controlsOf(const QWidget& panel) {
    std::vector<QWidget*> controls;
    const auto* const first = &panel;
    for (QWidget* each = first->nextInFocusChain(); each != first; each = each->nextInFocusChain()) {
        if (panel.isAncestorOf(each) && isControl(*each, panel)) controls.push_back(each);
    }
    return controls;
}

/// The item `direction` places on; the last is followed by the first.
QWidget* neighbour(const std::vector<QWidget*>& round, const QWidget* now, int direction) {
    const auto place = std::ranges::find(round, now) - round.begin();
    const auto count = static_cast<std::ptrdiff_t>(round.size());
    return round[static_cast<std::size_t>(place == count ? 0 : (place + direction + count) % count)];
}

double axis(const PadButtons& now, PadButton less, PadButton more) {
    return static_cast<double>(now.isDown(more)) - static_cast<double>(now.isDown(less));
}

}  // namespace

GamepadNavigation::GamepadNavigation(QMainWindow& window, ToothView& view) : window_(window), view_(view) {}

void GamepadNavigation::setGamepad(const std::optional<std::string>& pad) {
    name_ = pad.value_or(std::string());
    if (pad.has_value() == (joysticks_ != nullptr)) return;
    // The desktop's own dialogs receive no keys from this program.
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs, pad.has_value());
    joysticks_.reset();
    last_.reset();
    arrow_.reset();
    control_ = nullptr;
    capturesInput_ = false;
    if (!pad) return;
    if (auto joysticks = SdlJoysticks::shared()) joysticks_ = std::move(*joysticks);
}

const JoystickState* GamepadNavigation::find(const std::vector<JoystickState>& joysticks) const {
    const auto found = std::ranges::find_if(joysticks, [this](const JoystickState& each) {
        return each.isPad && each.name.find(name_) != std::string::npos;
    });
    return found == joysticks.end() ? nullptr : &*found;
}

bool GamepadNavigation::step(double dt) {
    if (joysticks_ == nullptr) return false;
    if (control_ != nullptr && (!control_->isVisible() || window_.focusWidget() == &shownView())) control_ = nullptr;
    const std::vector<JoystickState> joysticks = joysticks_->states();
    const JoystickState* const pad = find(joysticks);
    const PadButtons now = pad != nullptr ? pad->padButtons : PadButtons();
    const bool isNew = !last_ || pad == nullptr;  // a button that was down before does not count
    const bool pressed = !isNew && handlePresses(now);
    last_ = pad != nullptr ? std::optional(now) : std::nullopt;
    const bool isElsewhere = frontWidget() != nullptr || control_ != nullptr;
    if (isElsewhere) {
        repeatArrow(now, dt);
    } else if (!capturesInput_) {
        orbitBy(now, dt);
    }
    const bool anyDown = std::ranges::find(now.down, true) != now.down.end();
    capturesInput_ = isElsewhere || (capturesInput_ && anyDown);
    return pressed || anyDown;
}

bool GamepadNavigation::handlePresses(const PadButtons& now) {
    bool any = false;
    for (std::size_t i = 0; i < kPadButtons; ++i) {
        for (std::uint32_t n = last_->presses[i]; n < now.presses[i]; ++n) {
            press(static_cast<PadButton>(i));
            any = true;
        }
    }
    return any;
}

void GamepadNavigation::press(PadButton button) {
    if (arrowKeyOf(button)) {
        arrow_ = button;
        untilRepeat_ = kFirstRepeat;
    }
    if (QWidget* const taker = frontWidget()) return pressOnFrontWidget(button, *taker);
    if (control_ != nullptr) return pressInPanel(button);
    if (button == PadButton::Start) openMenus();
    if (button == PadButton::Back) enterPanels();
    if (button == PadButton::X) shownView().markAtTip();
}

/// The widget that receives the keys of an open menu or dialog, or of the manual in front; null if there is none.
QWidget* GamepadNavigation::frontWidget() const {
    QWidget* const active = QApplication::activeWindow();
    for (QWidget* const front : {QApplication::activePopupWidget(), QApplication::activeModalWidget(),
                                 qobject_cast<QDialog*>(active) != nullptr ? active : nullptr}) {
        if (front != nullptr) return front->focusWidget() != nullptr ? front->focusWidget() : front;
    }
    // The keys have chosen an entry of the menu bar. The bar may have the focus without an entry; an entry under the
    // mouse is active without the focus.
    QMenuBar* const bar = window_.menuBar();
    return window_.focusWidget() == bar && bar->activeAction() != nullptr ? bar : nullptr;
}

/// Whether it is a menu of the menu bar. There Escape may only return to the bar, and a second one is needed.
bool GamepadNavigation::isMenuOfBar(const QWidget& front) const {
    const auto* const menu = qobject_cast<const QMenu*>(&front);
    return menu != nullptr && window_.menuBar()->actions().contains(menu->menuAction());
}

/// Posts the key to the widget that is in front when the key is processed. In a slow window two presses come at once,
/// and the first of them may open another menu.
void GamepadNavigation::postToFrontWidget(Qt::Key key) {
    const auto send = [this, key] {
        const QPointer<QWidget> taker = frontWidget();
        if (taker == nullptr) return;
        QKeyEvent pressed(QEvent::KeyPress, key, Qt::NoModifier);
        QCoreApplication::sendEvent(taker, &pressed);
        if (taker == nullptr) return;
        QKeyEvent released(QEvent::KeyRelease, key, Qt::NoModifier);
        QCoreApplication::sendEvent(taker, &released);
    };
    QMetaObject::invokeMethod(&window_, send, Qt::QueuedConnection);
}

void GamepadNavigation::pressOnFrontWidget(PadButton button, QWidget& taker) {
    using enum PadButton;
    if (const auto key = arrowKeyOf(button)) return postToFrontWidget(*key);
    switch (button) {
        case A:
            return activate(taker);
        case B:
            return isMenuOfBar(taker) ? closeFrontWidget() : post(taker, Qt::Key_Escape);
        case LeftShoulder:
            return postToFrontWidget(Qt::Key_Backtab);
        case RightShoulder:
            return postToFrontWidget(Qt::Key_Tab);
        case Start:
            return closeFrontWidget();
        default:
            return;
    }
}

/// Closes all menus of any depth, or one dialog.
void GamepadNavigation::closeFrontWidget() {
    bool closed = false;
    while (QWidget* const popup = QApplication::activePopupWidget()) {
        if (!popup->close()) return;
        closed = true;
    }
    if (QWidget* const taker = frontWidget(); taker != nullptr && !closed) post(*taker, Qt::Key_Escape);
}

void GamepadNavigation::openMenus() {
    const QList<QAction*> menus = window_.menuBar()->actions();
    if (!menus.isEmpty()) window_.menuBar()->setActiveAction(menus.front());
}

void GamepadNavigation::pressInPanel(PadButton button) {
    using enum PadButton;
    switch (button) {
        case Up:
            return goToControl(-1);
        case Down:
            return goToControl(1);
        case Left:
        case Right:
            return post(*control_, valueKey(*control_, button == Right));
        case A:
            return activate(*control_);
        case B:
        case Back:
            return leavePanels();
        case LeftShoulder:
            return goToPanel(-1);
        case RightShoulder:
            return goToPanel(1);
        case Start:
            return openMenus();
        default:
            return;
    }
}

/// The picture in the middle of the window: in a replay it is that of the recording.
ToothView& GamepadNavigation::shownView() const {
    if (view_.isVisible()) return view_;
    for (auto* const view : window_.findChildren<ToothView*>()) {
        if (view->isVisible() && view->window() == &window_) return *view;
    }
    return view_;
}

/// Tool bars and docks that have controls, and the controls below a recording; docks behind others count too.
std::vector<QWidget*> GamepadNavigation::panels() const {
    std::vector<QWidget*> all;
    const auto add = [&all](QWidget* panel) {
        if (!panel->isHidden() && !controlsOf(*panel).empty()) all.push_back(panel);
    };
    for (auto* const bar : window_.findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly)) add(bar);
    for (auto* const dock : window_.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) add(dock);
    auto* const replay = window_.findChild<QWidget*>("replayBar");
    if (replay != nullptr && replay->isVisible()) add(replay);
    return all;
}

QWidget* GamepadNavigation::panelOf(const QWidget& control) const {
    const std::vector<QWidget*> all = panels();
    const auto found = std::ranges::find_if(all, [&](const QWidget* each) { return each->isAncestorOf(&control); });
    return found == all.end() ? nullptr : *found;
}

void GamepadNavigation::enterPanels() {
    const std::vector<QWidget*> all = panels();
    if (all.empty()) return;
    const bool isThere = std::ranges::find(all, lastPanel_.data()) != all.end();
    take(*controlsOf(isThere ? *lastPanel_ : *all.front()).front());
}

void GamepadNavigation::leavePanels() {
    control_ = nullptr;
    shownView().setFocus();
}

void GamepadNavigation::goToPanel(int direction) {
    const std::vector<QWidget*> all = panels();
    if (!all.empty()) take(*controlsOf(*neighbour(all, panelOf(*control_), direction)).front());
}

void GamepadNavigation::goToControl(int direction) {
    const QWidget* const panel = panelOf(*control_);
    if (panel == nullptr) return leavePanels();
    take(*neighbour(controlsOf(*panel), control_, direction));
}

/// Moves to `control`, makes it visible and marks it.
void GamepadNavigation::take(QWidget& control) {
    control_ = &control;
    lastPanel_ = panelOf(control);
    if (lastPanel_ != nullptr) lastPanel_->raise();
    control.window()->setAttribute(Qt::WA_KeyboardFocusChange);
    control.setFocus(Qt::TabFocusReason);
    for (QWidget* above = control.parentWidget(); above != nullptr; above = above->parentWidget()) {
        if (auto* area = qobject_cast<QScrollArea*>(above)) area->ensureWidgetVisible(&control);
    }
}

/// Repeats an arrow that is held in a menu, a dialog or a panel.
void GamepadNavigation::repeatArrow(const PadButtons& now, double dt) {
    if (arrow_ && !now.isDown(*arrow_)) arrow_.reset();
    if (!arrow_) return;
    untilRepeat_ -= dt;
    if (untilRepeat_ > 0) return;
    const PadButton button = *arrow_;
    press(button);
    untilRepeat_ = kNextRepeat;
}

/// The d-pad turns the tooth. With the right shoulder button, which holds the bur, it shifts the picture. Pressing the
/// sticks zooms in and out. While Y is held, they do the same with the mirror: it moves, tilts, comes and goes.
void GamepadNavigation::orbitBy(const PadButtons& now, double dt) {
    using enum PadButton;
    const Vec2 direction = kOrbitSpeed * dt * Vec2(axis(now, Left, Right), axis(now, Up, Down));
    if (now.isDown(Y)) {
        if (!direction.isZero(0)) shownView().moveMirror(direction, now.isDown(RightShoulder));
        const double toEye = axis(now, LeftStick, RightStick);
        if (toEye != 0) shownView().approachMirror(kMirrorApproach * toEye * dt);
        return;
    }
    if (!direction.isZero(0)) shownView().orbitBy(direction, now.isDown(RightShoulder));
    const double nearer = axis(now, LeftStick, RightStick);
    if (nearer != 0) shownView().zoomBy(std::pow(kNearer, nearer * dt));
}

}  // namespace tactooth
