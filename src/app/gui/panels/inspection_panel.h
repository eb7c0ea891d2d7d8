// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

#include "app/common/inspection.h"
#include "app/gui/model/target.h"

namespace tactooth {

/// How one looks into the tooth: a section, transparent tissues, two eyes; a target as colours by the distance to it,
/// or as the ghost of what it wants to have cut.
class InspectionPanel final : public QWidget {
    Q_OBJECT

public:
    explicit InspectionPanel(QWidget* parent = nullptr);

    /// The section cuts `box`; `mesialX`: direction of mesial along x; `materials`: of the tooth.
    [[nodiscard]] Inspection inspection(const Box3& box, double mesialX, const MaterialRegistry& materials) const;
    [[nodiscard]] Stereo::Mode stereo() const;
    /// For the tooth on the bench, whose colours are shown at once; empty: none.
    void setTarget(Target target);
    /// What has been chosen here.
    struct Choice {
        int section = 0, place = 0, enamel = 100, dentin = 100, stereo = 0;  ///< as the controls count
        bool coloured = false, ghost = false;
    };
    [[nodiscard]] Choice choice() const;
    /// Colours and ghost only as far as the target has them.
    void choose(const Choice& choice);
    /// Shows the ghost; enabled where the target has one.
    [[nodiscard]] QAction* ghostAction() const { return showGhost_; }

signals:
    void changed();
    /// The user wants to choose the file of a target.
    void targetRequested();

private:
    void explainGhost();

    QComboBox* section_;
    QSlider* place_;  // of the section, tenths of a mm from the middle
    QSlider* enamel_;
    QSlider* dentin_;
    QComboBox* stereo_;
    QPushButton* choose_;
    QCheckBox* coloured_;
    QCheckBox* ghost_;
    QAction* showGhost_;
    Target target_;
};

}  // namespace tactooth
