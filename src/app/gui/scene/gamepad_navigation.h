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

/// Works the window by a gamepad instead of mouse and keyboard: it opens menus, moves through menus, dialogs and
/// panels, and turns the picture. While one of them has the pad, the pad must not move the tool: see capturesInput.
class GamepadNavigation {
public:
    GamepadNavigation(QMainWindow& window, ToothView& view);

    /// Uses the first pad whose name contains `pad`; none: reads no pad.
    void setGamepad(const std::optional<std::string>& pad);
    /// Call it at least as often as the picture changes. `dt`: since the last step, s. Returns whether the user uses
    /// the pad.
    bool step(double dt);

    /// A menu, a dialog or a panel has the pad, or a button that was pressed for it is still down.
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
    [[nodiscard]] ToothView& shownView() const;
    [[nodiscard]] std::vector<QWidget*> panels() const;
    [[nodiscard]] QWidget* panelOf(const QWidget& control) const;
    [[nodiscard]] QWidget* frontWidget() const;
    [[nodiscard]] bool isMenuOfBar(const QWidget& front) const;

    QMainWindow& window_;
    ToothView& view_;
    std::shared_ptr<SdlJoysticks> joysticks_;  // null: no pad is read
    std::string name_;
    std::optional<PadButtons> last_;  // none: no pad has been connected yet
    std::optional<PadButton> arrow_;  // the one that is held
    double untilRepeat_ = 0;          // s
    QPointer<QWidget> control_;       // where the pad is; null: outside the panels
    QPointer<QWidget> lastPanel_;
    bool capturesInput_ = false;
};

}  // namespace tactooth
