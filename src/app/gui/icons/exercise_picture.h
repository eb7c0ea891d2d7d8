// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>

namespace tactooth {

struct Exercise;

/// The ideal of a built-in exercise (data/exercises/pictures); null for any other.
[[nodiscard]] QPixmap exercisePicture(const Exercise& exercise);

}  // namespace tactooth
