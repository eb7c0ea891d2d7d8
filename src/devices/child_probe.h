// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "geometry/expected.h"

namespace tactooth {

/// Calls `probe` in a child process and gives the text that it returns: a library that crashes or hangs takes the child
/// down and not the program. Fails with a few words: how the child ended. Call it while the program has one thread: a
/// child gets no other.
[[nodiscard]] Expected<std::string> inChildProcess(const std::function<std::string()>& probe, double seconds);

}  // namespace tactooth
