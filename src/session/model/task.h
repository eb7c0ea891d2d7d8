// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "geometry/util/expected.h"

namespace tactooth {

/// Runs one function and returns the thread that runs it; no thread if the function has run already.
using TaskExecutor = std::function<std::jthread(std::function<void()>)>;

/// The usual executor: each function gets a thread of its own.
[[nodiscard]] inline std::jthread runInThread(std::function<void()> work) { return std::jthread(std::move(work)); }

/// Runs long work in the background, one piece at a time. If several pieces are started while one runs, only the last
/// of them runs after it. All functions are for one thread. The destructor waits for the running work.
template <class T>
class Task {
public:
    using Function = std::function<Expected<T>()>;

    explicit Task(TaskExecutor executor = runInThread) : executor_(std::move(executor)) {}

    void start(Function work) {
        if (isBusy()) {
            pending_ = std::move(work);
            return;
        }
        auto job = std::make_shared<std::packaged_task<Expected<T>()>>(std::move(work));
        running_ = job->get_future();
        worker_ = executor_([job] { (*job)(); });
    }

    /// From `start` until `poll` has fetched the result.
    [[nodiscard]] bool isBusy() const { return running_.valid(); }

    /// Whether `poll` will return a result: work runs or waits that was not cancelled.
    [[nodiscard]] bool isAwaited() const { return isBusy() && (!isCancelled_ || pending_); }

    /// Waits until `poll` has something to fetch.
    void wait() const {
        if (isBusy()) running_.wait();
    }

    /// Drops the result of the running work, and the work that waits.
    void cancel() {
        pending_ = nullptr;
        isCancelled_ = isBusy();
    }

    /// The result of the last work that was started, once.
    [[nodiscard]] std::optional<Expected<T>> poll() {
        if (!isBusy() || running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
        const bool isCancelled = std::exchange(isCancelled_, false);
        Expected<T> result = running_.get();
        if (pending_) {
            start(std::exchange(pending_, nullptr));
            return std::nullopt;
        }
        if (isCancelled) return std::nullopt;
        return result;
    }

private:
    TaskExecutor executor_;
    std::future<Expected<T>> running_;
    Function pending_;
    bool isCancelled_ = false;  // the running work
    std::jthread worker_;       // last: its destructor waits for the work
};

}  // namespace tactooth
