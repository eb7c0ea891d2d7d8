// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <mutex>
#include <string>
#include <thread>

namespace tactooth::test {

/// A running hand_parent (see hand_parent.cpp): a program that holds a device through tactooth-hand, for a test to end
/// or to stop. It is ended with the object.
class ParentProgram {
public:
    explicit ParentProgram(const std::string& device);
    ~ParentProgram();
    ParentProgram(const ParentProgram&) = delete;
    ParentProgram& operator=(const ParentProgram&) = delete;

    [[nodiscard]] pid_t id() const { return id_; }
    void signal(int number) const;
    /// The process number of its newest tactooth-hand; 0 before there is one.
    [[nodiscard]] pid_t hand() const;
    /// What it says is wrong at present; empty: nothing.
    [[nodiscard]] std::string fault() const;
    /// Since when its servo has been spinning (SIGUSR1), s of the monotonic clock; 0: it has not said so.
    [[nodiscard]] double spinsFrom() const;
    /// Everything that it has said.
    [[nodiscard]] std::string said() const;

private:
    void listen(int pipe);

    pid_t id_ = 0;
    mutable std::mutex mutex_;  // protects all members below but the thread
    pid_t hand_ = 0;
    std::string fault_;
    double spinsFrom_ = 0;
    std::string said_;
    std::jthread listener_;
};

/// Whether a process has ended: it is gone, or a zombie.
[[nodiscard]] bool hasEnded(pid_t process);

}  // namespace tactooth::test
