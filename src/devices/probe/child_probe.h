// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "geometry/util/expected.h"

namespace tactooth {

/// Calls `probe` in a child process and gives the text that it returns: a library that crashes or hangs takes the child
/// down and not the program. Only a child that says through a pipe that it has come to its end counts, whatever its
/// exit status; what it has started is ended with it. Fails with a few words: how the child ended. The text holds no
/// byte of zero. The child gets none of the program's other threads, so `probe` may not need them, nor a lock that one
/// of them may hold; the heap and the loader of libraries are safe (glibc frees their locks in a child).
[[nodiscard]] Expected<std::string> inChildProcess(const std::function<std::string()>& probe, double seconds);

}  // namespace tactooth
