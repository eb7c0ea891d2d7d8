// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/icons/exercise_picture.h"

#include "assessment/exercise.h"

namespace tactooth {

QPixmap exercisePicture(const Exercise& exercise) {
    if (exercise.id.empty()) return {};
    return QPixmap(QString(":/exercises/pictures/%1.jpg").arg(QString::fromStdString(exercise.id)));
}

}  // namespace tactooth
