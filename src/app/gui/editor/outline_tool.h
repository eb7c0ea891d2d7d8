// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "app/gui/editor/draft_marks.h"
#include "app/gui/scene/surface_tool.h"

namespace tactooth {

/// What a click on the tooth draws.
enum class DraftStroke { Outline, Zone, Decay };

/// Draws an exercise on its tooth by mouse and keys: a click adds a point, or closes the open line at its first one; a
/// drag moves a point; a click of the right button, or Delete, removes it. Decay is painted: a click or a drag adds
/// places, and a click of the right button removes the one under it.
class OutlineTool final : public QObject, public SurfaceTool {
    Q_OBJECT

public:
    /// `draft` stays there until another one is given; null: there is none. Another one begins with its outline.
    void setDraft(ExerciseDraft* draft);
    void setStroke(DraftStroke stroke) { stroke_ = stroke; }
    [[nodiscard]] DraftStroke stroke() const { return stroke_; }
    /// The zone to which new points belong: the one that was touched last; nothing: a click begins one.
    [[nodiscard]] std::optional<int> zone() const;
    void setZone(int zone) { zone_ = zone; }
    /// The point that the mouse is on.
    [[nodiscard]] const std::optional<DraftPoint>& held() const { return held_; }
    /// The mouse is down: a line, or a stroke of decay, is not complete yet.
    [[nodiscard]] bool isInStroke() const { return drags_ || paints_; }

    void press(const Surface& surface, const Viewport& picture, const Vec2& pixel) override;
    void release() override;
    void move(const Surface& surface, const Viewport& picture, const Vec2& pixel) override;
    void clickRight(const Viewport& picture, const Vec2& pixel) override;
    [[nodiscard]] bool wants(const QKeySequence& keys) const override;
    void obey(const QKeySequence& keys) override;

signals:
    /// The draft, or the point that the mouse is on.
    void changed();

private:
    [[nodiscard]] std::optional<DraftPoint> pointAt(const Viewport& picture, const Vec2& pixel) const;
    void hold(const std::optional<DraftPoint>& point);
    void add(const Vec3& place, const Vec3& normal);
    void remove(const DraftPoint& point);
    void paint(const Vec3& place);

    ExerciseDraft* draft_ = nullptr;
    DraftStroke stroke_ = DraftStroke::Outline;
    int zone_ = 0;
    std::optional<DraftPoint> held_;
    bool drags_ = false;
    bool paints_ = false;
    int drag_ = 0;  // number of the drag: each is a step of its own
};

}  // namespace tactooth
