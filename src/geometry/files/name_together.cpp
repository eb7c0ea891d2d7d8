// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/name_together.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>

namespace tactooth {
namespace {

// What follows runs in a child of a program with many threads: it calls the system and nothing else.

int nameOne(const Naming& naming) {
    if (!naming.isOpen) return ::rename(naming.from.c_str(), naming.to.c_str()) == 0 ? 0 : errno;
    const auto linkAs = [&](const std::string& name) {
        return ::linkat(AT_FDCWD, naming.from.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
    };
    const int failure = linkAs(naming.to);
    if (failure != EEXIST) return failure;
    if (const int other = linkAs(naming.spare); other != 0) return other;  // a link replaces nothing, a new name does
    if (::rename(naming.spare.c_str(), naming.to.c_str()) == 0) return 0;
    const int reason = errno;
    ::unlink(naming.spare.c_str());
    return reason;
}

void takeBack(const Naming& naming) {
    if (!naming.backup.empty()) {
        ::rename(naming.backup.c_str(), naming.to.c_str());
    } else if (naming.replaces) {
        return;  // the older file is gone: the new one is better than none
    } else if (naming.isOpen) {
        ::unlink(naming.to.c_str());
    } else {
        ::rename(naming.to.c_str(), naming.from.c_str());
    }
}

NamingFailure nameAll(const std::vector<Naming>& namings) {
    NamingFailure failure;
    while (failure.which < namings.size()) {
        failure.reason = nameOne(namings[failure.which]);
        if (failure.reason != 0) break;
        ++failure.which;
    }
    if (failure.reason != 0) {
        for (std::size_t i = failure.which; i-- > 0;) takeBack(namings[i]);
    }
    for (const Naming& naming : namings) {
        if (!naming.backup.empty()) ::unlink(naming.backup.c_str());
    }
    return failure;
}

/// The whole life of the child.
[[noreturn]] void nameAndTell(const std::vector<Naming>& namings, int pipe) {
    ::setsid();  // a signal to the group, as the terminal sends it, is not for it either
    const NamingFailure failure = nameAll(namings);
    (void)!::write(pipe, &failure, sizeof failure);
    _exit(0);
}

}  // namespace

NamingFailure nameTogether(const std::vector<Naming>& namings) {
    int ends[2];
    if (namings.size() < 2 || ::pipe2(ends, O_CLOEXEC) != 0) return nameAll(namings);
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const pid_t child = ::fork();
    if (child == 0) nameAndTell(namings, ends[1]);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    ::close(ends[1]);
    NamingFailure failure{EIO, 0};
    if (child < 0) {
        failure = nameAll(namings);
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
