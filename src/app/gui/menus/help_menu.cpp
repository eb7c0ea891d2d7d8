// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/help_menu.h"

#include <QMenuBar>

#include "app/gui/controllers/tooth_controller.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/dialogs/text_dialog.h"
#include "app/gui/dialogs/welcome_dialog.h"
#include "app/gui/icons/line_icon.h"
#include "session/io/commit.h"

namespace tactooth {

HelpMenu::HelpMenu(QMenuBar& bar, QWidget& window, ToothController& teeth, GuidedTour& tour, WindowMessages& messages)
    : window_(window), teeth_(teeth), tour_(tour), messages_(messages) {
    QMenu* menu = bar.addMenu(tr("&Help"));
    setLineIcon(*menu->addAction(tr("&Welcome"), this, &HelpMenu::welcome), "welcome");
    setLineIcon(*menu->addAction(tr("Watch the &demonstration"), &tour_, &GuidedTour::start), "demonstration");
    QAction* keys = menu->addAction(tr("&Mouse and keys"), this, &HelpMenu::showMouseAndKeys);
    keys->setShortcut(QKeySequence("F1"));
    setLineIcon(*keys, "keys");
    setLineIcon(*menu->addAction(tr("&About Tactooth"), this, &HelpMenu::showAbout), "about");
}

void HelpMenu::welcome() {
    auto* dialog = new WelcomeDialog(&window_);
    connect(dialog, &WelcomeDialog::toothRequested, &teeth_, &ToothController::askForScan);
    connect(dialog, &WelcomeDialog::demonstrationRequested, &tour_, &GuidedTour::start);
    dialog->open();
}

void HelpMenu::showMouseAndKeys() {
    const auto row = [](const QString& what, const QString& effect) {
        return "<tr><td><b>" + what + "</b>&nbsp;&nbsp;&nbsp;</td><td>" + effect + "</td></tr>";
    };
    QString text = "<table>";
    text += row(tr("Move"), tr("the bur hovers over the point under the mouse"));
    text += row(tr("Left button"), tr("the bur goes down to the depth that is set; drag to stroke or cut"));
    text +=
        row(tr("Wheel"), tr("that depth, in steps of 0.1 mm, with Shift 0.02 mm; by force: press harder or softer"));
    text += row(tr("Shift + move"), tr("lean the bur"));
    text += row(tr("Right button"), tr("turn the tooth"));
    text += row(tr("Middle button"), tr("shift the picture"));
    text += row(tr("Ctrl + wheel"), tr("nearer or farther"));
    text += row(tr("Arrow keys"), tr("move the bur; with Shift lean it, with Ctrl turn the tooth"));
    text += row(tr("Enter"), tr("the bur presses, as long as you hold it"));
    text += row(tr("+, -"), tr("nearer or farther"));
    text += row(tr("Space"), tr("the pedal, as long as you hold it"));
    text += row(tr("T, C"), tr("touch, cut"));
    text += row(tr("0 to 5, F"), tr("views; show the whole crown"));
    text += row(tr("Ctrl + 0 to 5"), tr("a small picture from that side beside the large one; none"));
    text += row(tr("Q, E, U"), tr("turn the handle; stand the bur upright"));
    text += row(tr("M, H, J"), tr("mirror, turbine, aim on and off"));
    text += row(tr("G"), tr("the cavity that the target wants cut, on and off"));
    text += row(tr("L, Z"), tr("glass handpiece; magnifier of the bur's head"));
    text += row(tr("R, A, K"), tr("scale bar, letters of the directions, view cube"));
    text += row(tr("I, V"), tr("measure a distance, an angle between walls: click two places; Esc clears, and ends"));
    text += row(tr("B, D"), tr("breath and drops on the mirror"));
    text += row(tr("W, S"), tr("water spray, suction on and off"));
    text += row(tr("Ctrl + Z"), tr("take back the last cut or change"));
    text += row(tr("Ctrl + Shift + Z, Ctrl + Y"), tr("do it again"));
    text += row(tr("Ctrl + R"), tr("put back all that was cut"));
    text += row(tr("Ctrl + O, S, Shift + S"), tr("open a tooth, save it, export its surface"));
    text += row(tr("Ctrl + I"), tr("import a scan"));
    text += row(tr("Ctrl + T"), tr("the tooth chart; there arrow keys, numbers and Enter choose a tooth"));
    text += row(tr("Ctrl + B"), tr("the burs; there arrow keys, letters of the search and Enter choose one"));
    text += row(tr("Ctrl + D"), tr("dark colours"));
    text += row(tr("X"), tr("hold the bur while the hand of a device moves on"));
    text += row(tr("Gamepad: sticks"), tr("left: move; right: lean the bur"));
    text += row(tr("Gamepad: left trigger, shoulder"), tr("press, lift"));
    text += row(tr("Gamepad: right trigger, shoulder"), tr("pedal, hold"));
    text += row(tr("Gamepad: A, B"), tr("touch or cut, turbine or mirror"));
    text += row(tr("Gamepad: d-pad"), tr("turn the tooth; with the right shoulder shift the picture"));
    text += row(tr("Gamepad: sticks, pressed in"), tr("left: farther; right: nearer"));
    text += row(tr("Gamepad: Start, Back"), tr("open the menus; go into the panels, shoulders: the next one"));
    text += row(tr("Gamepad: d-pad, A, B"), tr("in menus, dialogs and panels: go on, choose, leave"));
    text += row(tr("Ctrl + M"), tr("mute"));
    text += row(tr("Tab, Alt + letter"), tr("go on to the next control; open a menu"));
    text += row(tr("Esc"), tr("leave a dialog"));
    (new TextDialog(tr("Mouse and keys"), text + "</table>", &window_))->open();
}

void HelpMenu::showAbout() {
    messages_.show(QMessageBox::NoIcon, tr("About Tactooth"),
                   tr("<b>Tactooth %1</b> (%2)<br>See, feel and hear a dental bur touch and cut a tooth.<br><br>"
                      "Free software under the GNU General Public License, version 3 or later;<br>"
                      "its simulation library under the Apache License 2.0.")
                       .arg(TACTOOTH_VERSION, kCommit));
}

}  // namespace tactooth
