// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "geometry/util/expected.h"

namespace tactooth {

/// The font family for a report on paper in this language: one for all its letters, so that numbers look alike. Fails
/// with one sentence if no font has its letters. Needs no display.
[[nodiscard]] Expected<QString> reportFont(Language language);

}  // namespace tactooth
