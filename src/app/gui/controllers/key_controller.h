// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/gui/controllers/window_panels.h"
#include "app/gui/keys/key_map.h"
#include "app/gui/settings/window_settings.h"

class QWidget;

namespace tactooth {

class WindowMessages;

/// The keys of the window: gives them to actions, picture and pedal, keeps the user's own in the settings, and opens
/// their editor.
class KeyController final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the controller.
    KeyController(QWidget& window, const WindowPanels& panels, WindowMessages& messages);

    [[nodiscard]] const KeyMap& map() const { return map_; }
    /// Gives all keys to what is in the window now.
    void apply();
    /// Opens the editor of the keys.
    void edit();

    /// Takes the keys, and says once which of them cannot be used. Call it before the device panel takes its settings.
    void restore(const WindowSettings& settings);
    void store(WindowSettings& settings) const;
    /// As the settings keep it.
    [[nodiscard]] std::string pedalKey() const;

signals:
    /// The user has chosen another key.
    void changed();

private:
    void followPanel();

    QWidget& window_;
    WindowPanels panels_;
    WindowMessages& messages_;
    KeyMap map_;
};

}  // namespace tactooth
