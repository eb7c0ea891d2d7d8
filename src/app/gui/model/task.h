// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <optional>

#include "geometry/util/expected.h"

namespace tactooth {

/// One piece of long work at a time, done by another thread while the window goes on. Of wishes that come while it
/// works only the last one counts. Used from one thread; going away waits for the work to end.
template <class T>
class Task {
public:
    using Function = std::function<Expected<T>()>;

    void start(Function work) {
        if (isBusy()) {
            pending_ = std::move(work);
        } else {
            running_ = std::async(std::launch::async, std::move(work));
        }
    }

    [[nodiscard]] bool isBusy() const { return running_.valid(); }

    /// Nobody wants what is being done any more: its result will not be delivered.
    void cancel() {
        pending_ = nullptr;
        isCancelled_ = isBusy();
    }

    /// The result, once, when the last wish is done.
    [[nodiscard]] std::optional<Expected<T>> poll() {
        if (!isBusy() || running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
        Expected<T> result = running_.get();
        const bool isCancelled = std::exchange(isCancelled_, false);
        if (pending_) {
            start(std::exchange(pending_, nullptr));
            return std::nullopt;
        }
        if (isCancelled) return std::nullopt;
        return result;
    }

private:
    std::future<Expected<T>> running_;
    Function pending_;
    bool isCancelled_ = false;  // what is running
};

}  // namespace tactooth
