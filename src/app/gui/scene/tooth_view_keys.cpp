// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys that work in the picture.
#include <QKeyEvent>
#include <array>
#include <utility>

#include "app/gui/scene/session_scene.h"
#include "app/gui/scene/tooth_view.h"

namespace tactooth {
namespace {

constexpr double kKeyStep = 0.006;  // of the picture's height for one press of an arrow key: 0.2 mm on a molar
constexpr double kKeyTurn = 6;      // times kKeyStep for a turn of the tooth

}  // namespace

/// Keys of the tool come before the shortcuts of the window.
bool ToothView::event(QEvent* event) {
    SurfaceTool* const tool = activeTool();
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (tool == nullptr || !isKey) return QOpenGLWidget::event(event);
    const QKeySequence keys(static_cast<QKeyEvent*>(event)->keyCombination());
    if (!tool->wants(keys)) return QOpenGLWidget::event(event);
    if (event->type() == QEvent::KeyPress) tool->obey(keys);
    event->accept();
    return true;
}

/// Four keys move the hand like the mouse; with a modifier they turn the tooth. One presses while it is held.
bool ToothView::obeyKey(const QKeyEvent& key) {
    const std::array<std::pair<int, Vec2>, 4> directions = {
        {{keys_.left, Vec2(-1, 0)}, {keys_.right, Vec2(1, 0)}, {keys_.up, Vec2(0, -1)}, {keys_.down, Vec2(0, 1)}}};
    const ImageSize size = pictureSize(*this);
    if (mouse_.x() < 0) mouse_ = Vec2(size.width / 2.0, size.height / 2.0);
    for (const auto& [code, displacement] : directions) {
        if (key.key() != code) continue;
        const Vec2 pixels = kKeyStep * size.height * displacement;
        if (contents_ || (key.modifiers() & keys_.turn)) {
            moveCamera(kKeyTurn * pixels, Qt::RightButton);
        } else {
            moveHand(mouse_ + pixels, key.modifiers());
        }
        return true;
    }
    if (!contents_ && isPress(key)) {
        if (key.isAutoRepeat()) return true;
        if (SurfaceTool* tool = activeTool()) {
            tool->press(*touchableSurface(model_), viewport(), mouse_);
            tool->release();
            return true;
        }
        if (isMeasuring()) {
            measure_->pick(*touchableSurface(model_), model_.tooth()->piece->tooth(), viewport(), mouse_);
            return true;
        }
        pressHand();
        isPressedByKey_ = true;
        return true;
    }
    if (!contents_ && key.key() == keys_.holdMirror) {
        holdMirror(true);
        return true;
    }
    if (key.key() != keys_.nearer && key.key() != keys_.farther) return false;
    if (mirrorMouse_.isHeld()) {
        approachMirror(key.key() == keys_.nearer ? kMirrorStep : -kMirrorStep);
        return true;
    }
    camera_.zoom(key.key() == keys_.nearer ? kZoomStep : 1 / kZoomStep, mouse_, size);
    redraw();
    return true;
}

/// The large and the small Enter key are one.
bool ToothView::isPress(const QKeyEvent& key) const {
    return key.key() == keys_.press || (keys_.press == Qt::Key_Return && key.key() == Qt::Key_Enter);
}

void ToothView::keyPressEvent(QKeyEvent* event) {
    if (!obeyKey(*event)) QOpenGLWidget::keyPressEvent(event);
}

void ToothView::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == keys_.holdMirror && !event->isAutoRepeat()) return holdMirror(false);
    if (!isPress(*event)) return QOpenGLWidget::keyReleaseEvent(event);
    if (!event->isAutoRepeat()) endKeyPress();
}

}  // namespace tactooth
