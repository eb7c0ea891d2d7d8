// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "devices/process/hand_process.h"

namespace tactooth {

/// Keeps the hand process of one device running, from a thread of its own. A process that ends is started again after a
/// second, a few times. The servo thread never waits for this: it only asks for the link of the moment.
class HandSupervisor {
public:
    static constexpr int kMaxRestarts = 10;  ///< without ten seconds of work in between

    explicit HandSupervisor(HandRequest request);
    ~HandSupervisor();
    HandSupervisor(const HandSupervisor&) = delete;
    HandSupervisor& operator=(const HandSupervisor&) = delete;

    /// Starts the process and waits until it has opened the device. Fails with one sentence.
    [[nodiscard]] Expected<void> start();
    /// Ends the process, in order if it answers. No thread may use a link any more.
    void stop();

    /// Any thread; wait-free. The link to the process that runs at present; nullptr: none runs. A link stays valid
    /// until stop().
    [[nodiscard]] HandLink* link() const { return link_.load(std::memory_order_acquire); }
    /// Any thread: why no process runs, and what to do; nullptr while one runs. Lives as long as the program.
    [[nodiscard]] const Message* faultMessage() const;
    /// Any thread: the process number; 0 while none runs.
    [[nodiscard]] pid_t processId() const { return processId_.load(std::memory_order_relaxed); }

private:
    void run(const std::stop_token& stop);
    [[nodiscard]] bool runOnce(const std::stop_token& stop);
    [[nodiscard]] Expected<HandLink*> startProcess(const std::stop_token& stop);
    void forgetProcess(HandLink& link);
    [[nodiscard]] bool fail(const Error& error);

    HandRequest request_;
    std::atomic<HandLink*> link_{nullptr};
    std::atomic<const Message*> faultMessage_{nullptr};
    std::atomic<pid_t> processId_{0};
    int failures_ = 0;  // of the thread: ends without ten seconds of work before

    mutable std::mutex mutex_;  // protects all members below
    std::condition_variable_any changed_;
    std::list<HandMemory> memories_;  // one for each start: the servo thread may still use an old one
    std::unique_ptr<HandProcess> process_;
    bool hasOpened_ = false;           // a first process has opened the device
    bool hasFinished_ = true;          // the thread starts no process any more
    std::optional<Error> firstError_;  // why the first process has not opened the device
    std::jthread thread_;              // last member: it uses all others
};

}  // namespace tactooth
