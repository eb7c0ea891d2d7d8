// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/examination_mode.h"

#include <utility>

#include "geometry/util/assert.h"
#include "session/model/session_model.h"

namespace tactooth {

bool ExaminationMode::allowsAnotherTooth() const { return !isOn() || !model_.isTouched(); }

void ExaminationMode::begin(std::shared_ptr<const SigningKey> seal) {
    TACTOOTH_ASSERT(seal != nullptr && !model_.isTouched());
    seal_ = std::move(seal);
    model_.setExamination(true);
    emit changed();
}

void ExaminationMode::finish() {
    if (!isOn()) return;
    seal_.reset();
    model_.setExamination(false);
    emit changed();
}

}  // namespace tactooth
