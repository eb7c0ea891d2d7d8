// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

#include "app/common/inspection.h"
#include "app/gui/model/target.h"

namespace tactooth {

/// Views into the tooth: a section, transparent tissues, stereo; a target as colours by the distance, or as the ghost
/// of the volume to be cut.
class InspectionPanel final : public QWidget {
    Q_OBJECT

public:
    explicit InspectionPanel(QWidget* parent = nullptr);

    /// The section plane cuts `box`; `mesialX`: direction of mesial along x; `materials`: of the tooth.
    [[nodiscard]] Inspection inspection(const Box3& box, double mesialX, const MaterialRegistry& materials) const;
    [[nodiscard]] Stereo::Mode stereo() const;
    /// Where the bur's tip is, in the tooth's frame, mm: a section that follows the bur goes there, in tenths of a mm.
    void followBur(const Vec3& tip, const Box3& box, double mesialX);
    /// Sets the target of the tooth and shows its colours; empty: no target.
    void setTarget(Target target);
    static constexpr double kUsualTolerance = 0.1;  ///< mm
    /// The user's choices.
    struct Choice {
        int section = 0, place = 0, enamel = 100, dentin = 100, stereo = 0;  ///< in the units of the controls
        bool coloured = false, ghost = false;
        double tolerance = kUsualTolerance;  ///< mm
        bool follows = false;                ///< the section follows the bur
    };
    [[nodiscard]] Choice choice() const;
    /// Colours and ghost are chosen only if the target has them.
    void choose(const Choice& choice);
    /// Shows the ghost; enabled if the target has one.
    [[nodiscard]] QAction* ghostAction() const { return showGhost_; }

signals:
    void changed();
    /// The user wants to choose the file of a target.
    void targetRequested();

private:
    void explainGhost();
    void enablePlace();

    QComboBox* section_;
    QSlider* place_;  // of the section, tenths of a mm from the centre
    QCheckBox* follows_;
    QSlider* enamel_;
    QSlider* dentin_;
    QComboBox* stereo_;
    QPushButton* choose_;
    QCheckBox* coloured_;
    QDoubleSpinBox* tolerance_;  // mm
    QCheckBox* ghost_;
    QAction* showGhost_;
    Target target_;
};

}  // namespace tactooth
