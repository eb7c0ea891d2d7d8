// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/expected.h"

namespace tactooth {

/// Whether a window can be opened: tries it in a child process, as Qt would, which ends the program by itself where
/// there is no display. Fails with one sentence, for behind "tactooth: ", that says what to do. A server that
/// never answers is told within three seconds. Call it while the program has no thread that works.
[[nodiscard]] Expected<void> checkDisplay();

}  // namespace tactooth
