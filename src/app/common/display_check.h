// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/util/expected.h"

namespace tactooth {

/// Checks whether a window can be opened. It tries this in a child process, as Qt would, because Qt ends the program if
/// there is no display. Fails with one sentence that gives the remedy, to be printed after "tactooth: ". A server that
/// never answers is reported within three seconds. Call it while no other thread of the program is running.
[[nodiscard]] Expected<void> checkDisplay();

}  // namespace tactooth
