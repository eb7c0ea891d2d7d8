// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

#include "app/common/inspection.h"

namespace tactooth {

/// How one looks into the tooth: a section, transparent tissues, colours by the distance to a target, two eyes.
class InsidePanel final : public QWidget {
    Q_OBJECT

public:
    explicit InsidePanel(QWidget* parent = nullptr);

    /// The section cuts `box`; `mesialX`: direction of mesial along x.
    [[nodiscard]] Inspection inspection(const Box3& box, double mesialX) const;
    [[nodiscard]] Stereo::Mode stereo() const;
    /// Colours for the tooth on the bench; null: none. `name`: of the target.
    void setTarget(std::shared_ptr<const DistanceGrid> grid, const QString& name);

signals:
    void changed();
    /// The user wants to choose the file of a target.
    void targetWanted();

private:
    QComboBox* section_;
    QSlider* place_;  // of the section, tenths of a mm from the middle
    QSlider* enamel_;
    QSlider* dentin_;
    QComboBox* stereo_;
    QPushButton* choose_;
    QCheckBox* coloured_;
    std::shared_ptr<const DistanceGrid> target_;
};

}  // namespace tactooth
