// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/probe/child_probe.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "devices/base/messages.h"
#include "devices/base/monotonic_clock.h"
#include "geometry/util/system_reason.h"

namespace tactooth {
namespace {

// What the child says last, behind its answer. An exit status alone proves nothing: a library that calls exit(0) while
// it is loaded ends with the same one. No answer holds a byte of zero.
constexpr std::string_view kOk("\0ok", 3);
constexpr int kEnded = 3;          // exit status of a child that a library has ended
constexpr int kUnheard = 4;        // of one that could not say its answer
constexpr int kPollTimeoutMs = 5;  // between two looks whether a child has ended that has closed its pipe

/// exit() would run what the whole program does at its end: settings saved, files removed, threads waited for that are
/// not there. What is registered last comes first.
void endAtOnce() { _exit(kEnded); }

/// As if nothing had been set: the program may catch or block signals that shall end this child.
void resetSignals() {
    for (const int number : {SIGSEGV, SIGABRT, SIGBUS, SIGILL, SIGFPE, SIGTERM, SIGINT, SIGHUP, SIGPIPE, SIGXFSZ}) {
        signal(number, SIG_DFL);
    }
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
}

bool writeAll(int pipe, std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = write(pipe, text.data(), text.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

/// The child's whole life; an exception that leaves `probe` ends it too. What a library prints about itself is not for
/// the user.
[[noreturn]] void answer(int pipe, const std::function<std::string()>& probe) noexcept {
    setpgid(0, 0);                     // so that what it starts can be ended with it
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // a Ctrl+C ends the program alone: the child is of another group
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
    resetSignals();
    std::atexit(endAtOnce);
    const std::string text = probe();
    _exit(writeAll(pipe, text) && writeAll(pipe, kOk) ? 0 : kUnheard);
}

enum class ReceiveStatus { Answer, Nothing, TooLate };

/// Reads until the child has said that it is done, or has closed its end. Whoever else may hold the pipe open, as a
/// process that a library has left behind, is not waited for.
ReceiveStatus readAnswer(int pipe, MonotonicClock::time_point end, std::string& text) {
    std::array<char, 4096> buffer;
    while (!text.ends_with(kOk)) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - MonotonicClock::now()).count();
        pollfd waiting{pipe, POLLIN, 0};
        const int ready = left > 0 ? poll(&waiting, 1, static_cast<int>(left)) : 0;
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) return ReceiveStatus::TooLate;
        const ssize_t count = read(pipe, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return ReceiveStatus::Nothing;
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    text.resize(text.size() - kOk.size());
    return ReceiveStatus::Answer;
}

/// Why there is no answer, a few words. The child is not waited for so that nobody else gets its number yet.
Message wordsFor(pid_t child, MonotonicClock::time_point end) {
    siginfo_t info{};
    while (info.si_pid == 0) {
        const int failed = waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT);
        if (failed != 0 && errno != EINTR) break;  // this program waits for no child: how it ended is not known
        if (info.si_pid != 0) break;
        if (MonotonicClock::now() > end) return msg::kDoesNotReturn;
        poll(nullptr, 0, kPollTimeoutMs);
    }
    if (info.si_code == CLD_KILLED || info.si_code == CLD_DUMPED) {
        return {msg::kCrashes, strsignal(info.si_status)};
    }
    if (info.si_code == CLD_EXITED && info.si_status == kUnheard) return msg::kClosesWhatIsNotItsOwn;
    return msg::kEndsTheProgram;
}

/// Ends the child with all that it has started.
void killProcessGroup(pid_t child) {
    kill(-child, SIGKILL);
    kill(child, SIGKILL);
    while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
}

}  // namespace

Expected<std::string> inChildProcess(const std::function<std::string()>& probe, double seconds) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return unexpected(msg::kNoPipe, systemReason(errno));
    const pid_t child = fork();
    if (child == 0) answer(ends[1], probe);
    close(ends[1]);
    if (child < 0) {
        close(ends[0]);
        return unexpected(msg::kNoChildProcess, systemReason(errno));
    }
    setpgid(child, child);  // whoever comes first
    const MonotonicClock::time_point end = secondsFromNow(seconds);
    std::string text;
    const ReceiveStatus heard = readAnswer(ends[0], end, text);
    close(ends[0]);
    const Message why = heard == ReceiveStatus::Nothing ? wordsFor(child, end) : Message(msg::kDoesNotReturn);
    killProcessGroup(child);
    if (heard == ReceiveStatus::Answer) return text;
    return unexpected(why);
}

}  // namespace tactooth
