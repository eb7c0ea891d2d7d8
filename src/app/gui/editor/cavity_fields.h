// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <array>

#include "app/gui/editor/draft_fields.h"

namespace tactooth {

/// Depth, walls and floor of the cavity, its proximal boxes, and the decay.
class CavityFields final : public DraftFields {
    Q_OBJECT

public:
    CavityFields();

protected:
    void showDraft(const ExerciseDraft& draft) override;

private:
    /// The fields of a box on one side.
    struct BoxFields {
        QCheckBox* has;
        std::array<QDoubleSpinBox*, 3> measures;  // width, axial depth, axial height
    };
    void addBox(std::size_t side, const QString& title, const char* name);
    void addDecay();
    void showBox(const BoxFields& fields, const ExerciseDraft& draft, double towardX) const;

    QComboBox* side_;
    QDoubleSpinBox* depth_;
    QDoubleSpinBox* taper_;
    QComboBox* floor_;
    std::array<BoxFields, 2> boxes_{};  // mesial, distal
    QCheckBox* hasDecay_;
    QDoubleSpinBox* decayWidth_;
    QDoubleSpinBox* decayDepth_;
    QDoubleSpinBox* rimWidth_;
};

}  // namespace tactooth
