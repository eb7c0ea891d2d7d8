// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "app/gui/input/viewport.h"
#include "session/hands/mirror_view.h"
#include "session/model/tip_measure.h"

namespace tactooth {

/// Drawn over the tooth view: where the bur will land, a plumb line from its tip to there, and beside the tip its depth
/// below the uncut surface, the tooth that is left over the pulp, and the force. What stands behind the tooth is
/// dashed. The colour warns before it is too late. Ring and line are drawn in the mouth mirror, too, as it shows them.
class AimOverlay final : public QWidget {
    Q_OBJECT

public:
    explicit AimOverlay(QWidget* parent);

    /// The mouth mirror in the picture.
    struct Mirror {
        MirrorDisc glass;
        bool isAimedInto = false;  ///< the numbers then stand beside the tip in the mirror
    };
    /// What is shown; it is drawn anew only if it has changed.
    void show(const SessionModel& model, const Viewport& picture, const std::optional<Mirror>& mirror);
    /// Shows nothing, for example while a recording is replayed.
    void showNothing();
    /// Off: only the ring and the line, without numbers and warnings.
    void setShowsNumbers(bool shows);
    /// The text beside the tip, line by line.
    [[nodiscard]] const QStringList& lines() const { return mark_.lines; }
    [[nodiscard]] TipWarning warning() const { return mark_.warning; }
    /// Whether a part of the ring is marked as touching what stands beside the tooth.
    [[nodiscard]] bool marksBeside() const;
    /// The landing ring in the picture, pixels of the widget.
    [[nodiscard]] QPolygonF ring() const { return polygonOf(mark_.direct.ring); }
    /// The same in the mirror; empty where it cannot be there.
    [[nodiscard]] QPolygonF ringInMirror() const { return polygonOf(mark_.inMirror.ring); }
    /// The glass in the picture; empty without a mirror, or if it is seen from behind.
    [[nodiscard]] const QPolygonF& glass() const { return mark_.glass; }
    /// Whether the landing ring is drawn at `place` or near it, pixels of the widget.
    [[nodiscard]] bool isRingAt(const QPointF& place) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Place {
        QPointF at;
        bool isHidden = false;
        bool touchesBeside = false;
        bool operator==(const Place&) const = default;
    };
    struct Lines {
        std::vector<Place> ring;
        std::vector<Place> plumb;  // from the tip to the landing place
        bool operator==(const Lines&) const = default;
    };
    struct Mark {
        Lines direct, inMirror;
        QPolygonF glass;
        QPointF tip;  // that the numbers belong to
        QStringList lines;
        TipWarning warning = TipWarning::None;
        bool operator==(const Mark&) const = default;
    };

    /// What a mark is computed from. Nothing is computed anew as long as it is the same.
    struct Source {
        const Surface* surface = nullptr;
        Vec3 tip = Vec3::Zero(), shaft = Vec3::Zero(), inward = Vec3::Zero(), eye = Vec3::Zero();
        Eigen::Vector4d eyeTurn = Eigen::Vector4d::Zero();
        double depth = 0, force = 0, hold = 0;
        PressMode mode = PressMode::Depth;
        int width = 0, height = 0;
        bool showsNumbers = true;
        Vec3 glass = Vec3::Zero(), glassNormal = Vec3::Zero();
        double glassRadius = 0;
        bool isAimedIntoMirror = false;
        bool operator==(const Source&) const = default;
    };
    using Projection = std::function<std::optional<Place>(const Vec3&)>;
    [[nodiscard]] Source sourceOf(const SessionModel& model, const Viewport& picture,
                                  const std::optional<Mirror>& mirror) const;

    [[nodiscard]] Mark markFor(const SessionModel& model, const Viewport& picture,
                               const std::optional<Mirror>& mirror) const;
    [[nodiscard]] Projection directly(const SessionModel& model, const Viewport& picture,
                                      const std::optional<Mirror>& mirror) const;
    [[nodiscard]] Projection throughMirror(const SessionModel& model, const Viewport& picture,
                                           const MirrorDisc& glass) const;
    [[nodiscard]] Lines linesFor(const AimMark& aim, const Projection& placeOf) const;
    [[nodiscard]] QStringList textFor(const SessionModel& model, const TipMeasure& measure) const;
    [[nodiscard]] static QPolygonF polygonOf(const std::vector<Place>& places);
    void paintLines(QPainter& painter, const Lines& lines) const;
    [[nodiscard]] QRect textPlace() const;
    [[nodiscard]] QRect bounds() const;
    void set(Mark mark);

    Mark mark_;
    std::optional<Source> source_;  // of the mark; none: it shows nothing
    bool showsNumbers_ = true;
};

}  // namespace tactooth
