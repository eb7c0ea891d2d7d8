// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/rename_together.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>

namespace tactooth {
namespace {

// The code below runs in a child of a program with many threads: it uses system calls only.

int renameOne(const PendingRename& pending) {
    if (!pending.isOpen) return ::rename(pending.from.c_str(), pending.to.c_str()) == 0 ? 0 : errno;
    const auto linkAs = [&](const std::string& name) {
        return ::linkat(AT_FDCWD, pending.from.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
    };
    const int failure = linkAs(pending.to);
    if (failure != EEXIST) return failure;
    if (const int other = linkAs(pending.spare); other != 0) return other;  // a link replaces nothing, a rename does
    if (::rename(pending.spare.c_str(), pending.to.c_str()) == 0) return 0;
    const int reason = errno;
    ::unlink(pending.spare.c_str());
    return reason;
}

void takeBack(const PendingRename& pending) {
    if (!pending.backup.empty()) {
        ::rename(pending.backup.c_str(), pending.to.c_str());
    } else if (pending.replaces) {
        return;  // the older file is gone: the new one is better than none
    } else if (pending.isOpen) {
        ::unlink(pending.to.c_str());
    } else {
        ::rename(pending.to.c_str(), pending.from.c_str());
    }
}

RenameFailure renameAll(const std::vector<PendingRename>& renames) {
    RenameFailure failure;
    while (failure.which < renames.size()) {
        failure.reason = renameOne(renames[failure.which]);
        if (failure.reason != 0) break;
        ++failure.which;
    }
    if (failure.reason != 0) {
        for (std::size_t i = failure.which; i-- > 0;) takeBack(renames[i]);
    }
    for (const PendingRename& pending : renames) {
        if (!pending.backup.empty()) ::unlink(pending.backup.c_str());
    }
    return failure;
}

/// The main function of the child.
[[noreturn]] void renameAndReport(const std::vector<PendingRename>& renames, int pipe) {
    ::setsid();  // a signal to the process group, as the terminal sends it, must not reach the child
    const RenameFailure failure = renameAll(renames);
    (void)!::write(pipe, &failure, sizeof failure);
    _exit(0);
}

}  // namespace

RenameFailure renameTogether(const std::vector<PendingRename>& renames) {
    int ends[2];
    if (renames.size() < 2 || ::pipe2(ends, O_CLOEXEC) != 0) return renameAll(renames);
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const pid_t child = ::fork();
    if (child == 0) renameAndReport(renames, ends[1]);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    ::close(ends[1]);
    RenameFailure failure{EIO, 0};
    if (child < 0) {
        failure = renameAll(renames);
    } else {
        ssize_t count = 0;
        do {
            count = ::read(ends[0], &failure, sizeof failure);
        } while (count < 0 && errno == EINTR);
        while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    ::close(ends[0]);
    return failure;
}

}  // namespace tactooth
