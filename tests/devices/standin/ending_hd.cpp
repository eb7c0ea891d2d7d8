// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A library that, while it is being loaded, does to its program what TACTOOTH_TEST_ENDING names: in most cases it ends
// it.
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace {

void closeAll() {
    for (int file = 0; file < 1024; ++file) close(file);
}

void write(int file, const char* text, std::size_t length) {
    const ssize_t ignored = ::write(file, text, length);
    (void)ignored;
}

int endAs(const std::string& ending) {
    if (ending == "exit") std::exit(0);
    if (ending == "exit at exit") std::atexit([] { std::exit(0); });
    if (ending == "_exit" || ending == "exit at exit") _exit(0);
    if (ending == "quick_exit") std::quick_exit(0);
    if (ending == "abort") std::abort();
    if (ending == "throw") throw std::runtime_error("no licence");
    if (ending == "terminate") std::raise(SIGTERM);
    if (ending == "kill") std::raise(SIGKILL);
    if (ending == "hang") pause();
    if (ending == "stop") std::raise(SIGSTOP);
    if (ending == "close") closeAll();
    if (ending == "close and hang") closeAll(), pause();
    if (ending == "close and exit") closeAll(), _exit(0);
    if (ending == "say ok") {
        for (const int file : {1, 2}) write(file, "ok\n\0ok", 6);
        _exit(0);
    }
    if (ending == "leave a process" && fork() == 0) sleep(60), _exit(0);
    if (ending == "leave a process and exit") {
        if (fork() == 0) sleep(60);
        _exit(0);
    }
    return 0;
}

[[maybe_unused]] const int ended = [] {
    const char* const ending = std::getenv("TACTOOTH_TEST_ENDING");
    return ending != nullptr ? endAs(ending) : 0;
}();

}  // namespace
