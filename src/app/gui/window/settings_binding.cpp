// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/window/settings_binding.h"

#include <QString>
#include <string>

#include "app/gui/menus/window_menus.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/force_panel.h"
#include "app/gui/window/window_parts.h"

namespace tactooth {

SettingsBinding::SettingsBinding(WindowFrame& frame, WorkControllers& work, InputControllers& input,
                                 OutputControllers& output, WindowMenus& menus, WorkTools& tools)
    : frame_(frame), work_(work), input_(input), output_(output), menus_(menus), tools_(tools) {}

void SettingsBinding::apply(const WindowSettings& settings) {
    frame_.docks.restore(settings);
    frame_.files.setFolder(QString::fromStdString(settings.folder));
    frame_.panels.drill->choose(QString::fromStdString(settings.bur), QString::fromStdString(settings.spindle));
    menus_.restore(settings);
    frame_.panels.force->set(settings.force);
    input_.keys.restore(settings);
    DeviceSettings hand = settings.hand;
    hand.pedalKey = input_.keys.pedalKey();
    input_.devices.apply(hand);
    output_.sounds.restore(settings);
    work_.recordings.restore(settings);
    tools_.replay.comparison().restore(settings);
}

WindowSettings SettingsBinding::current() const {
    WindowSettings settings;
    frame_.docks.store(settings);
    work_.examinations.store(settings);
    settings.folder = frame_.files.folder().toStdString();
    settings.bur = frame_.panels.drill->burNumber().toStdString();
    settings.spindle = frame_.panels.drill->spindleName().toStdString();
    menus_.store(settings);
    settings.force = frame_.panels.force->settings();
    settings.hand = input_.devices.settings();
    input_.keys.store(settings);
    output_.sounds.store(settings);
    work_.recordings.store(settings);
    tools_.replay.comparison().store(settings);
    return settings;
}

void SettingsBinding::change(const WindowSettings& wanted) {
    const WindowSettings now = current();
    frame_.files.setFolder(QString::fromStdString(wanted.folder));
    const auto changed = [](const std::string& before, const std::string& after) {
        return before == after ? QString() : QString::fromStdString(after);
    };
    frame_.panels.drill->choose(changed(now.bur, wanted.bur), changed(now.spindle, wanted.spindle));
    menus_.restore(wanted);
    tools_.replay.comparison().restore(wanted);
    if (wanted.force != now.force) frame_.panels.force->set(wanted.force);
    input_.devices.change(wanted.hand);
    output_.sounds.change(wanted);
    const bool recordsOtherwise =
        wanted.recordsSessions != now.recordsSessions || wanted.recordingGigabytes != now.recordingGigabytes;
    if (recordsOtherwise) work_.recordings.restore(wanted);
}

}  // namespace tactooth
