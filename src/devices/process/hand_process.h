// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/process/fault_log.h"
#include "devices/process/hand_memory.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// The program `tactooth-hand`, in the folder of the running program.
[[nodiscard]] std::filesystem::path handProgram();

/// What a hand process is started for.
struct HandRequest {
    std::string device;  ///< see openDevice
    bool leftHanded = false;
    double rateHz = 1000;
    std::filesystem::path program = handProgram();
    std::filesystem::path faultLog = faultLogFile();
};

/// The arguments of tactooth-hand. The program writes them and the hand process reads them.
struct HandArguments {
    static constexpr int kLinkFile = 3;       ///< the inherited file of the shared memory
    static constexpr int kOtherVersion = 3;   ///< exit status: the memory has another layout
    static constexpr int kHung = 4;           ///< exit status: the loop stood still
    static constexpr std::size_t kCount = 6;  ///< with the name of the program

    std::string device;
    bool leftHanded = false;
    double rateHz = 1000;
    std::string faultLog;
    pid_t program = 0;  ///< process number of the program

    [[nodiscard]] std::vector<std::string> words(const std::string& name) const;
    /// None if they are not such words.
    [[nodiscard]] static std::optional<HandArguments> from(const std::vector<std::string>& words);
};

/// How a hand process has ended.
struct HandEnd {
    HandFault cause = HandFault::HandEnded;
    int number = 0;  ///< of the signal, or the exit status
};

/// A running tactooth-hand, as its parent sees it. The thread that starts it lives as long as the process, because the
/// system notifies a child of the end of that thread.
class HandProcess {
public:
    /// Fails with one sentence where there is no such program.
    [[nodiscard]] static Expected<std::unique_ptr<HandProcess>> start(const HandRequest& request,
                                                                      const HandMemory& memory);
    ~HandProcess();
    HandProcess(const HandProcess&) = delete;
    HandProcess& operator=(const HandProcess&) = delete;

    /// Blocks until it has ended. One that is stopped is ended: nobody else could take the force off its device.
    [[nodiscard]] HandEnd wait();
    /// Ends it at once. Any thread.
    void kill() const;
    [[nodiscard]] pid_t id() const { return id_; }

private:
    HandProcess(pid_t id, int file) : id_(id), file_(file) {}

    pid_t id_;
    int file_;  // of the process (pidfd): its number may pass to another one
};

}  // namespace tactooth
