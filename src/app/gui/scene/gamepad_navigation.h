// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QPointer>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/sdl/joysticks.h"

namespace tactooth {

class ToothView;

/// A gamepad instead of mouse and keyboard: its buttons open the menus, walk through menus, dialogs and panels, and
/// turn the picture. As long as one of these has the pad, the pad must not work on the tooth: see capturesInput.
class GamepadNavigation {
public:
    GamepadNavigation(QMainWindow& window, ToothView& view);

    /// From now on the first pad whose name holds `pad` counts; nothing: none, and none is read.
    void setGamepad(const std::optional<std::string>& pad);
    /// Call at least as often as the picture changes. `dt`: since the last step, s. Returns whether it is being used.
    bool step(double dt);

    /// A menu, a dialog or a panel has the pad, or a button that was meant for one is still down.
    [[nodiscard]] bool capturesInput() const { return capturesInput_; }
    [[nodiscard]] bool isInPanels() const { return control_ != nullptr; }

private:
    [[nodiscard]] const JoystickState* find(const std::vector<JoystickState>& joysticks) const;
    bool handlePresses(const PadButtons& now);
    void press(PadButton button);
    void postToFrontWidget(Qt::Key key);
    void pressOnFrontWidget(PadButton button, QWidget& taker);
    void pressInPanel(PadButton button);
    void repeatArrow(const PadButtons& now, double dt);
    void orbitBy(const PadButtons& now, double dt);
    void closeFrontWidget();
    void openMenus();
    void enterPanels();
    void leavePanels();
    void goToControl(int direction);
    void goToPanel(int direction);
    void take(QWidget& control);
    [[nodiscard]] std::vector<QWidget*> panels() const;
    [[nodiscard]] QWidget* panelOf(const QWidget& control) const;
    [[nodiscard]] QWidget* frontWidget() const;
    [[nodiscard]] bool isMenuOfBar(const QWidget& front) const;

    QMainWindow& window_;
    ToothView& view_;
    std::shared_ptr<SdlJoysticks> joysticks_;  // none: not listening
    std::string name_;
    std::optional<PadButtons> last_;  // none: no pad has been there yet
    std::optional<PadButton> arrow_;  // that is held
    double untilRepeat_ = 0;          // s
    QPointer<QWidget> control_;       // that the pad is at; none: not in the panels
    QPointer<QWidget> lastPanel_;
    bool capturesInput_ = false;
};

}  // namespace tactooth
