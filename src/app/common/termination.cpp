// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/termination.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "app/common/exit_code.h"
#include "geometry/files/unfinished_files.h"

namespace tactooth {
namespace {

constexpr double kNamesTimeout = 5;  // s to wait for renames in progress before the program ends
constexpr int kEndings[] = {SIGINT, SIGTERM, SIGHUP};

int noticePipe[2] = {-1, -1};
pid_t ownNumber = 0;
std::atomic<int> askedBy{0};  // signal that asked for a graceful shutdown

std::mutex& orderMutex() {
    static auto* const mutex = new std::mutex;
    return *mutex;
}
std::function<void()>& orderly() {
    static auto* const asked = new std::function<void()>;
    return *asked;
}

void openStandardFiles() {
    for (int number = 0; number <= STDERR_FILENO; ++number) {
        if (::fcntl(number, F_GETFD) < 0 && errno == EBADF) (void)!::open("/dev/null", O_RDWR);
    }
}

void setHandler(int number, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    ::sigaction(number, &action, nullptr);
}

bool isIgnored(int number) {
    struct sigaction action {};
    return ::sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

/// Unlike SIG_IGN, child programs do not inherit this handler.
void doNothing(int) {}

void notice(int number) {
    const int error = errno;
    if (::getpid() == ownNumber) {
        const auto byte = static_cast<unsigned char>(number);
        (void)!::write(noticePipe[1], &byte, 1);
    } else {  // a child process before it becomes another program
        setHandler(number, SIG_DFL);
        ::raise(number);
    }
    errno = error;
}

void writeLine(const std::string& sentence) { (void)!::write(STDERR_FILENO, sentence.data(), sentence.size()); }

std::string nameOf(int number) {
    const char* const name = ::sigabbrev_np(number);
    return name == nullptr ? std::to_string(number) : std::string("SIG") + name;
}

[[noreturn]] void endBy(int number) {
    setHandler(number, SIG_DFL);
    sigset_t only;
    sigemptyset(&only);
    sigaddset(&only, number);
    pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
    ::kill(ownNumber, number);
    while (true) ::pause();
}

/// The next signal; 0 if none arrives within so many seconds.
int nextSignal(double seconds) {
    pollfd waiting{noticePipe[0], POLLIN, 0};
    constexpr double kMilli = 1000;
    while (true) {
        const int ready = ::poll(&waiting, 1, seconds < 0 ? -1 : static_cast<int>(kMilli * seconds));
        if (ready == 0) return 0;
        unsigned char byte = 0;
        if (ready > 0 && ::read(noticePipe[0], &byte, 1) == 1) return byte;
    }
}

/// Asks for a graceful shutdown; true if a GracefulShutdown exists.
bool askForOrder(int number) {
    const std::lock_guard lock(orderMutex());
    if (!orderly()) return false;
    askedBy = number;
    orderly()();
    return true;
}

void watchForSignals() {
    int number = nextSignal(-1);
    if (askForOrder(number)) {
        if (const int second = nextSignal(kShutdownGrace); second != 0) number = second;
    }
    removeAllUnfinished(kNamesTimeout);
    writeLine("tactooth: ended by " + nameOf(number) + " before it was done; no unfinished file is left.\n");
    endBy(number);
}

/// The handler of uncaught exceptions.
[[noreturn]] void terminateOnException() {
    std::string why = "it cannot go on";
    try {
        if (const std::exception_ptr exception = std::current_exception()) std::rethrow_exception(exception);
    } catch (const std::bad_alloc&) {
        why = "the memory does not suffice";
    } catch (const std::exception& exception) {
        why = exception.what();
    } catch (...) {
        why = "an exception of an unknown kind";
    }
    removeAllUnfinished(kNamesTimeout);
    writeLine("tactooth: ended by what it did not expect (" + why +
              "); no unfinished file is left, please report it.\n");
    ::_exit(kExitBadInput);
}

}  // namespace

void installTerminationHandlers() {
    openStandardFiles();
    ownNumber = ::getpid();
    std::set_terminate(terminateOnException);
    for (const int number : {SIGPIPE, SIGXFSZ}) setHandler(number, doNothing);
    if (::pipe2(noticePipe, O_CLOEXEC) != 0) return;  // then signals end the program as usual
    ::fcntl(noticePipe[1], F_SETFL, O_NONBLOCK);
    for (const int number : kEndings) {
        if (number != SIGHUP || !isIgnored(number)) setHandler(number, notice);
    }
    std::thread(watchForSignals).detach();
}

GracefulShutdown::GracefulShutdown(std::function<void()> asked) {
    const std::lock_guard lock(orderMutex());
    orderly() = std::move(asked);
}

GracefulShutdown::~GracefulShutdown() {
    const std::lock_guard lock(orderMutex());
    orderly() = nullptr;
}

int exitAsRequested(int exitCode) {
    const int number = askedBy;
    if (number == 0) return exitCode;
    writeLine("tactooth: closed by " + nameOf(number) + ".\n");
    endBy(number);
}

}  // namespace tactooth
