// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "process/parent_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>

namespace tactooth::test {

ParentProgram::ParentProgram(const std::string& device) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return;
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, ends[1], STDOUT_FILENO);
    std::string program = TACTOOTH_HAND_PARENT, name = device;
    char* words[] = {program.data(), name.data(), nullptr};
    (void)posix_spawn(&id_, program.c_str(), &files, nullptr, words, environ);
    posix_spawn_file_actions_destroy(&files);
    close(ends[1]);
    listener_ = std::jthread([this, pipe = ends[0]] { listen(pipe); });
}

ParentProgram::~ParentProgram() {
    signal(SIGKILL);
    waitpid(id_, nullptr, 0);
}

void ParentProgram::signal(int number) const {
    if (id_ > 0) ::kill(id_, number);
}

/// Reads to the end of the pipe: tactooth-hand does not inherit it.
void ParentProgram::listen(int pipe) {
    std::string line;
    for (char letter; read(pipe, &letter, 1) == 1;) {
        if (letter != '\n') {
            line += letter;
            continue;
        }
        const std::lock_guard lock(mutex_);
        said_ += line + '\n';
        if (line.starts_with("hand ")) hand_ = std::atoi(line.c_str() + 5);
        if (line.starts_with("fault ")) fault_ = line.substr(6);
        if (line == "no fault") fault_.clear();
        if (line.starts_with("spins ")) spinsFrom_ = std::strtod(line.c_str() + 6, nullptr);
        line.clear();
    }
    close(pipe);
}

pid_t ParentProgram::hand() const {
    const std::lock_guard lock(mutex_);
    return hand_;
}

std::string ParentProgram::fault() const {
    const std::lock_guard lock(mutex_);
    return fault_;
}

double ParentProgram::spinsFrom() const {
    const std::lock_guard lock(mutex_);
    return spinsFrom_;
}

std::string ParentProgram::said() const {
    const std::lock_guard lock(mutex_);
    return said_;
}

bool hasEnded(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string text;
    std::getline(file, text);
    const std::size_t name = text.rfind(')');
    return name == std::string::npos || text.substr(name + 2, 1) == "Z";
}

}  // namespace tactooth::test
