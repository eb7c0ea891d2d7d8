// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "geometry/io/remark.h"

namespace tactooth {

/// A remark on a scan in the language of the window.
[[nodiscard]] QString translated(const Remark& remark);

/// Whether the window has words of its own for this remark.
[[nodiscard]] bool isKnown(const Remark& remark);

}  // namespace tactooth
