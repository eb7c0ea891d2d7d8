// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/key_controller.h"

#include <QTimer>

#include "app/gui/controllers/window_messages.h"
#include "app/gui/dialogs/key_editor.h"
#include "app/gui/keys/key_binding.h"
#include "app/gui/keys/messages.h"
#include "app/gui/panels/device_panel.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/translation.h"

namespace tactooth {

KeyController::KeyController(QWidget& window, const WindowPanels& panels, WindowMessages& messages)
    : window_(window), panels_(panels), messages_(messages) {
    connect(panels_.device, &DevicePanel::changed, this, &KeyController::followPanel);
}

void KeyController::apply() {
    applyKeys(window_, map_);
    for (auto* const view : window_.findChildren<ToothView*>()) view->setKeys(PictureKeys(map_));
    panels_.device->setPedalKey(map_.keys(KeyId::Pedal).front());
}

void KeyController::edit() {
    auto* editor = new KeyEditor(map_, &window_);
    connect(editor, &KeyEditor::changed, this, [this, editor] {
        map_ = editor->map();
        apply();
        emit changed();
    });
    editor->open();
}

/// The panel of the devices shows the key of the pedal, too, and can change it.
void KeyController::followPanel() {
    const Keys wanted{QKeySequence(pedalKeyOf(panels_.device->settings()))};
    if (wanted == map_.keys(KeyId::Pedal)) return;
    if (const auto fault = map_.objection(KeyId::Pedal, wanted)) {
        panels_.device->setPedalKey(map_.keys(KeyId::Pedal).front());
        return messages_.showError(*fault);
    }
    map_.set(KeyId::Pedal, wanted);
    emit changed();
}

void KeyController::restore(const WindowSettings& settings) {
    const std::vector<Message> refused = map_.restore(settings.ownKeys, settings.hand.pedalKey);
    apply();
    if (refused.empty()) return;
    Message all = refused.front();
    for (std::size_t i = 1; i < refused.size(); ++i) all = Message(msg::kTwoSentences, all, refused[i]);
    // As soon as the window is there.
    QTimer::singleShot(0, this, [this, all] { messages_.showError(Error(msg::kKeyOwnRefused, all)); });
}

void KeyController::store(WindowSettings& settings) const { settings.ownKeys = map_.ownText(); }

std::string KeyController::pedalKey() const { return portableText(map_.keys(KeyId::Pedal).front()).toStdString(); }

}  // namespace tactooth
