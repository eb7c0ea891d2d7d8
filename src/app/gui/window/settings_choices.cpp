// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/window/settings_choices.h"

#include <QComboBox>

#include "app/gui/panels/device_panel.h"
#include "app/gui/text/translation.h"
#include "instruments/bur_catalogue.h"
#include "instruments/spindle.h"

namespace tactooth {
namespace {

SettingChoices entriesOf(const QComboBox& box) {
    SettingChoices result;
    for (int i = 0; i < box.count(); ++i) result.emplace_back(box.itemText(i), box.itemData(i).toString());
    return result;
}

}  // namespace

std::map<std::string, SettingChoices> settingsChoices(const WindowPanels& panels) {
    SettingChoices burs, drives;
    for (const BurSpec& spec : burCatalogue()) {
        burs.emplace_back(translated(spec.title), QString::fromStdString(spec.number));
    }
    for (const SpindlePreset& drive : spindlePresets()) {
        drives.emplace_back(translated(drive.name), QString::fromStdString(drive.name));
    }
    const QWidget& device = *panels.device;
    return {{"--drill-bur", burs},
            {"--drill-drive", drives},
            {"--hand-device", entriesOf(*device.findChild<QComboBox*>("devices"))},
            {"--hand-second-device", entriesOf(*device.findChild<QComboBox*>("secondDevices"))}};
}

}  // namespace tactooth
