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

// The end mark that the child writes after its answer. An exit status alone proves nothing: a library that calls
// exit(0) while it is being loaded has the same one. No answer contains a zero byte.
constexpr std::string_view kOk("\0ok", 3);
constexpr int kEnded = 3;          // exit status of a child that a library has ended
constexpr int kUnheard = 4;        // exit status of a child that could not write its answer
constexpr int kPollTimeoutMs = 5;  // between two checks whether a child that has closed its pipe has ended

/// exit() would run the exit handlers of the whole program: save settings, remove files, wait for threads that the
/// child does not have. The handler that is registered last runs first, so this one prevents the others.
void endAtOnce() { _exit(kEnded); }

/// Restores the default signal actions and unblocks all signals: the program may catch or block signals that must end
/// this child.
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

/// The entire run of the child; an exception that leaves `probe` ends it too. Output of a library is discarded, because
/// it is not for the user.
[[noreturn]] void answer(int pipe, const std::function<std::string()>& probe) noexcept {
    setpgid(0, 0);  // a process group of its own, so that processes that it starts can be ended with it
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // Ctrl+C ends only the program, because the child is in another group
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
    resetSignals();
    std::atexit(endAtOnce);
    const std::string text = probe();
    _exit(writeAll(pipe, text) && writeAll(pipe, kOk) ? 0 : kUnheard);
}

enum class ReceiveStatus { Answer, Nothing, TooLate };

/// Reads until the child has written the end mark or closed its end of the pipe. Does not wait for other processes that
/// hold the pipe open, such as one that a library has left behind.
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

/// A few words on why there is no answer. Does not reap the child, so that no other process gets its process number
/// yet.
Message wordsFor(pid_t child, MonotonicClock::time_point end) {
    siginfo_t info{};
    while (info.si_pid == 0) {
        const int failed = waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT);
        if (failed != 0 && errno != EINTR) break;  // this program cannot wait for children: how it ended is unknown
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

/// Ends the child and all processes that it has started.
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
    setpgid(child, child);  // parent and child both call it, in either order
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
