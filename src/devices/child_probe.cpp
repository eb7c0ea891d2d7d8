// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/child_probe.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "devices/monotonic_clock.h"

namespace tactooth {
namespace {

/// The child's whole life. What a library prints about itself is not for the user.
[[noreturn]] void answer(int pipe, const std::function<std::string()>& probe) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    for (const int number : {SIGSEGV, SIGABRT, SIGBUS, SIGILL, SIGFPE}) signal(number, SIG_DFL);
    const std::string text = probe();
    std::size_t sent = 0;
    while (sent < text.size()) {
        const ssize_t count = write(pipe, text.data() + sent, text.size() - sent);
        if (count <= 0) _exit(1);
        sent += static_cast<std::size_t>(count);
    }
    _exit(0);
}

/// Reads until the child closes its end; false if time runs out first.
bool readAll(int pipe, MonotonicClock::time_point end, std::string& text) {
    std::array<char, 4096> buffer;
    while (true) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - MonotonicClock::now()).count();
        pollfd waiting{pipe, POLLIN, 0};
        const int ready = left > 0 ? poll(&waiting, 1, static_cast<int>(left)) : 0;
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) return false;
        const ssize_t count = read(pipe, buffer.data(), buffer.size());
        if (count <= 0) return true;
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

}  // namespace

Expected<std::string> inChildProcess(const std::function<std::string()>& probe, double seconds) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return unexpected(std::string("no pipe: ") + std::strerror(errno));
    const pid_t child = fork();
    if (child == 0) answer(ends[1], probe);
    close(ends[1]);
    if (child < 0) {
        close(ends[0]);
        return unexpected(std::string("no child process: ") + std::strerror(errno));
    }
    std::string text;
    const bool finished = readAll(ends[0], secondsFromNow(seconds), text);
    close(ends[0]);
    if (!finished) kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    if (!finished) return unexpected("it does not return");
    if (WIFSIGNALED(status)) return unexpected(std::string("it crashes (") + strsignal(WTERMSIG(status)) + ")");
    if (WEXITSTATUS(status) != 0) return unexpected("it ends the program that uses it");
    return text;
}

}  // namespace tactooth
