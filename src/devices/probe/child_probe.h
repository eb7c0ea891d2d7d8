// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "geometry/util/expected.h"

namespace tactooth {

/// Calls `probe` in a child process and returns its text. A library that crashes or hangs ends the child and not the
/// program. A result counts only if the child confirms through a pipe that it has finished; the exit status does not
/// matter. Processes that the child has started are ended with it. Fails with a few words: how the child ended. The
/// text may contain no zero byte. The child has none of the program's other threads, so `probe` must not need them, nor
/// a lock that one of them may hold. The heap and the library loader are safe (glibc releases their locks in a child).
[[nodiscard]] Expected<std::string> inChildProcess(const std::function<std::string()>& probe, double seconds);

}  // namespace tactooth
