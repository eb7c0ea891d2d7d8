// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "geometry/io/import_note.h"

namespace tactooth {

/// A remark on a scan in the language of the window.
[[nodiscard]] QString translated(const ImportNote& importNote);

/// Whether the window has words of its own for this remark.
[[nodiscard]] bool isKnown(const ImportNote& importNote);

}  // namespace tactooth
