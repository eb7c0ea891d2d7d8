// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

// The open file of a process (Linux manual page pidfd_open(2)): it means this process for ever, while a number may pass
// to another one, and it is readable when the process has ended. By system calls, since the functions of glibc 2.36
// have no declaration for C++.

namespace tactooth {

/// -1 where there is no such process. The caller closes the file.
[[nodiscard]] inline int openProcessFile(pid_t process) {
    return static_cast<int>(syscall(SYS_pidfd_open, process, 0));
}

inline void signalProcess(int file, int signal) { (void)syscall(SYS_pidfd_send_signal, file, signal, nullptr, 0); }

}  // namespace tactooth
